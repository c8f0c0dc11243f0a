// SPDX-License-Identifier: MIT
#include "limits.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include "method.hpp"

namespace mpm::atlas {
namespace {

const std::vector<std::string> times{"USF", "USL", "MUSL"};

/// A block away from all faces, `cells` long where that is more than two particles.
Fill block(const Method& method, int per_edge, int cells, double offset) {
  const int count = std::max(2, per_edge * cells);
  Fill fill{.per_edge = double(per_edge), .count = {count, count, count}, .margin = {2, 2, 2}};
  for (int d = 0; d < 3; ++d) fill.offset[std::size_t(d)] = std::fmod(offset * (1 + .37 * d), 1);
  fill.poisson = method.dimension == 1 ? 0 : .2;
  return fill;
}

/// As many as show what neighbours do, where particles are few.
int cells_of_block(const Method& method, int per_edge) {
  if (method.dimension == 1) return per_edge > 8 ? 3 : 4;
  return per_edge == 1 ? 4 : per_edge == 2 ? 3 : per_edge <= 8 ? 2 : 1;
}

GrowthMap map_of(const Method& method, int per_edge, int offsets, int steps) {
  GrowthMap map{method.space, method.shape, method.integrator, per_edge};
  for (int k = 0; k < offsets; ++k) map.offsets.push_back((k + .5) / offsets);
  for (int k = 1; k <= steps; ++k) map.steps.push_back(2.4 * k / steps);
  map.growth.resize(map.offsets.size() * map.steps.size());
  map.certain.resize(map.offsets.size());
  for (int i = 0; i < offsets; ++i) {
    Random random{1};
    const auto step =
        method.at_rest(block(method, per_edge, cells_of_block(method, per_edge), map.offsets[std::size_t(i)]), random);
    map.certain[std::size_t(i)] = step->certain();
    for (int k = 0; k < steps; ++k)
      map.growth[std::size_t(i * steps + k)] = step->growth_rate(map.steps[std::size_t(k)], 120);
  }
  return map;
}

Limit limit_of(const Method& method, int per_edge, bool quick) {
  Limit worst{method.space, method.shape, method.integrator, per_edge, 1e9, 1e9, 1e9, 0};
  const int offsets = quick ? 3 : 8;
  for (int k = 0; k < offsets; ++k) {
    Random random{1};
    const auto step =
        method.at_rest(block(method, per_edge, method.dimension == 1 ? 4 : 2, (k + .2) / offsets), random);
    const double certain = step->certain(), limit = true_limit(*step);
    worst.certain = std::min(worst.certain, certain);
    worst.limit = std::min(worst.limit, limit);
    worst.nodal = std::min(worst.nodal, step->nodal_limit());
    worst.share += certain / limit / offsets;
  }
  return worst;
}

/// make(method, per_edge) of all jobs, side by side, each on one thread.
template <class Result, class Make>
std::vector<Result> of_all(const std::vector<std::pair<const Method*, int>>& jobs, const Make& make) {
  std::vector<Result> results(jobs.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < jobs.size(); ++k) results[k] = make(*jobs[k].first, jobs[k].second);
  return results;
}

}  // namespace

std::vector<GrowthMap> growth_maps(bool quick) {
  struct Resolution {
    std::vector<int> per_edge;
    int offsets, steps;
  };
  std::map<std::string, Resolution> spaces{
      {"1-D", {{1, 2, 4, 8, 20}, 10, 24}}, {"2-D", {{1, 2, 4, 8, 20}, 6, 12}}, {"3-D", {{1, 2, 4}, 4, 12}}};
  if (quick) spaces = {{"1-D", {{1, 2, 4}, 6, 12}}, {"2-D", {{1, 2}, 4, 8}}, {"3-D", {{1, 2}, 2, 8}}};
  std::vector<std::pair<const Method*, int>> jobs;
  for (const Method& method : methods())
    if (const auto space = spaces.find(method.space); space != spaces.end())
      for (const int n : space->second.per_edge) jobs.emplace_back(&method, n);
  return of_all<GrowthMap>(jobs, [&](const Method& method, int per_edge) {
    const Resolution& r = spaces.at(method.space);
    return map_of(method, per_edge, r.offsets, r.steps);
  });
}

std::vector<Limit> limits(bool quick) {
  std::vector<std::pair<const Method*, int>> jobs;
  for (const Method& method : methods()) {
    const bool line = method.space == "1-D" && std::ranges::find(times, method.integrator) != times.end();
    for (const int n : line ? quick ? std::vector{1, 2, 4} : std::vector{1, 2, 3, 4, 6, 8, 12, 20} : std::vector{2})
      jobs.emplace_back(&method, n);
  }
  return of_all<Limit>(jobs, [&](const Method& method, int per_edge) { return limit_of(method, per_edge, quick); });
}

}  // namespace mpm::atlas
