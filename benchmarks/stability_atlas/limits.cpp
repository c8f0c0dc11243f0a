// SPDX-License-Identifier: MIT
#include "limits.hpp"
#include <algorithm>
#include <cmath>
#include "fill_method.hpp"

namespace mpm::atlas {
namespace {

const std::vector<std::string> times{"USF", "USL", "MUSL"};

/// A block away from all faces, `cells` long where that is more than two particles.
Fill block(const FillMethod& method, int per_edge, int cells, double offset) {
  const int count = std::max(2, per_edge * cells);
  Fill fill{.per_edge = double(per_edge), .count = {count, count, count}, .margin = {2, 2, 2}};
  for (int d = 0; d < 3; ++d) fill.offset[std::size_t(d)] = std::fmod(offset * (1 + .37 * d), 1);
  fill.poisson = method.dimension == 1 ? 0 : .2;
  return fill;
}

/// As long as the matrices of its steps are handled at once.
int cells_of_block(const FillMethod& method, int per_edge) {
  if (method.dimension == 1) return per_edge > 8 ? 3 : 4;
  return per_edge == 1 ? 4 : per_edge == 2 ? 3 : 2;
}

GrowthMap map_of(const FillMethod& method, int per_edge, int offsets, int steps) {
  GrowthMap map{method.space, method.shape, method.integrator, per_edge};
  for (int k = 0; k < offsets; ++k) map.offsets.push_back((k + .5) / offsets);
  for (int k = 1; k <= steps; ++k) map.steps.push_back(2.4 * k / steps);
  map.growth.resize(map.offsets.size() * map.steps.size());
  map.certain.resize(map.offsets.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < offsets; ++i) {
    Random random{1};
    const auto step =
        method.linear(block(method, per_edge, cells_of_block(method, per_edge), map.offsets[std::size_t(i)]), random);
    map.certain[std::size_t(i)] = step->certain();
    for (int k = 0; k < steps; ++k)
      map.growth[std::size_t(i * steps + k)] = growth_rate(step->matrix(map.steps[std::size_t(k)]), 200);
  }
  return map;
}

Limit limit_of(const FillMethod& method, int per_edge, bool quick) {
  Limit worst{method.space, method.shape, method.integrator, per_edge, 1e9, 1e9, 1e9, 0};
  const int offsets = quick ? 3 : 8;
  std::vector<Limit> each(std::size_t(offsets), worst);
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < offsets; ++k) {
    Random random{1};
    const auto step = method.linear(block(method, per_edge, method.dimension == 1 ? 4 : 2, (k + .2) / offsets), random);
    each[std::size_t(k)].certain = step->certain();
    each[std::size_t(k)].limit = true_limit(*step);
    each[std::size_t(k)].nodal = step->nodal_limit();
  }
  for (const Limit& one : each) {
    worst.certain = std::min(worst.certain, one.certain);
    worst.limit = std::min(worst.limit, one.limit);
    worst.nodal = std::min(worst.nodal, one.nodal);
    worst.share += one.certain / one.limit / offsets;
  }
  return worst;
}

}  // namespace

std::vector<GrowthMap> growth_maps(bool quick) {
  std::vector<GrowthMap> maps;
  for (const FillMethod& method : fill_methods()) {
    if (!method.linear) continue;
    if (method.space == "1-D")
      for (const int n : quick ? std::vector{1, 2, 4} : std::vector{1, 2, 4, 8, 20})
        maps.push_back(map_of(method, n, quick ? 6 : 12, quick ? 12 : 24));
    if (method.space == "2-D")
      for (const int n : quick ? std::vector{1, 2} : std::vector{1, 2, 4})
        maps.push_back(map_of(method, n, quick ? 4 : 8, quick ? 8 : 16));
  }
  return maps;
}

std::vector<Limit> limits(bool quick) {
  std::vector<Limit> all;
  for (const FillMethod& method : fill_methods()) {
    if (!method.linear) continue;
    const bool line = method.space == "1-D" && std::ranges::find(times, method.integrator) != times.end();
    for (const int n : line ? quick ? std::vector{1, 2, 4} : std::vector{1, 2, 3, 4, 6, 8, 12, 20} : std::vector{2})
      all.push_back(limit_of(method, n, quick));
  }
  return all;
}

}  // namespace mpm::atlas
