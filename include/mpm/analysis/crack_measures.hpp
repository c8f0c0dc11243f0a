// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace mpm::analysis {

/// Damaged particles of a plane cross-section, one entry a particle, all spans of one length.
struct DamageSamples {
  std::span<const double> x{}, y{};    ///< from the centre of the hole, of the nearest of several, m
  std::span<const double> area{};      ///< m2 (volume for unit thickness)
  std::span<const double> damage{};    ///< of any kind, 0 to 1
  std::span<const double> crushing{};  ///< the part by shear and compression alone, 0 to 1
};

/// How to count.
struct CrackCount {
  double threshold{0.5};     ///< a particle is damaged where its damage exceeds this
  double ring_width{0.005};  ///< m, of the rings that average the crushing; about a particle
  double multiplicity{1};    ///< copies that make the full circle: 4 for a quarter model
};

/// Extent of the damage round a hole; all zero if nothing is damaged.
///
/// `reach`, and not the length of a connected crack: gaps of one particle cut a crack at random, while the reach is
/// stable over seeds and meshes. The percentile is by area, which is by count where particles are equal.
struct CrackMeasures {
  double reach{};           ///< m, radius that holds 99.5 % of the damaged area
  double along_x{};         ///< m, the same of the particles within 30 degrees of the x axis
  double along_y{};         ///< m, the same about the y axis
  double longest{};         ///< m, radius of the farthest damaged particle
  double area{};            ///< m2, damaged, on the full circle
  double crushed_area{};    ///< m2, where `crushing` exceeds the threshold, on the full circle
  double crushed_radius{};  ///< m, out to which the ring mean of `crushing` exceeds one half
};

/// Throws std::invalid_argument on spans of unequal length or a ring width that is not positive.
inline void check(const DamageSamples& samples, const CrackCount& count) {
  const std::size_t n = samples.x.size();
  for (const auto& column : {samples.y, samples.area, samples.damage, samples.crushing})
    if (column.size() != n)
      throw std::invalid_argument("DamageSamples: columns of " + std::to_string(n) + " and " +
                                  std::to_string(column.size()) + " particles; give all the same length");
  if (!(count.ring_width > 0)) throw std::invalid_argument("CrackCount: ring_width must be positive");
}

namespace detail {

struct RadiusAndArea {
  double radius{}, area{};
};

/// Smallest radius that holds the fraction `share` of the area of `set`; zero for an empty set.
inline double radius_holding(double share, std::vector<RadiusAndArea> set) {
  std::sort(set.begin(), set.end(), [](const auto& a, const auto& b) { return a.radius < b.radius; });
  double total = 0, inside = 0;
  for (const auto& s : set) total += s.area;
  for (const auto& s : set) {
    inside += s.area;
    if (inside >= share * total) return s.radius;
  }
  return set.empty() ? 0 : set.back().radius;
}

/// Outer edge of the last ring, going outward, before the first whose area-weighted mean of `crushing` is at most one
/// half. Rings that no particle centre meets are passed over.
inline double crushed_radius(const DamageSamples& p, const std::vector<double>& radius, double width) {
  std::vector<double> crushed, total;  // area, a ring
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const auto ring = static_cast<std::size_t>(radius[i] / width);
    if (ring >= total.size()) crushed.resize(ring + 1), total.resize(ring + 1);
    crushed[ring] += p.area[i] * p.crushing[i];
    total[ring] += p.area[i];
  }
  double edge = 0;
  for (std::size_t ring = 0; ring < total.size(); ++ring) {
    if (total[ring] == 0) continue;
    if (!(crushed[ring] > 0.5 * total[ring])) break;
    edge = width * static_cast<double>(ring + 1);
  }
  return edge;
}

}  // namespace detail

/// Measures the damage of `samples`. Throws std::invalid_argument as `check` does.
inline CrackMeasures crack_measures(const DamageSamples& samples, const CrackCount& count) {
  check(samples, count);
  const std::size_t n = samples.x.size();
  constexpr double share = 0.995;
  const double tan30 = 1 / std::numbers::sqrt3;
  std::vector<double> radius(n);
  std::vector<detail::RadiusAndArea> all, near_x, near_y;
  CrackMeasures result;
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = std::abs(samples.x[i]), dy = std::abs(samples.y[i]);
    radius[i] = std::hypot(dx, dy);
    if (samples.crushing[i] > count.threshold) result.crushed_area += count.multiplicity * samples.area[i];
    if (!(samples.damage[i] > count.threshold)) continue;
    const detail::RadiusAndArea here{radius[i], samples.area[i]};
    all.push_back(here);
    if (dy <= tan30 * dx) near_x.push_back(here);
    if (dx <= tan30 * dy) near_y.push_back(here);
    result.longest = std::max(result.longest, radius[i]);
    result.area += count.multiplicity * samples.area[i];
  }
  result.reach = detail::radius_holding(share, std::move(all));
  result.along_x = detail::radius_holding(share, std::move(near_x));
  result.along_y = detail::radius_holding(share, std::move(near_y));
  result.crushed_radius = detail::crushed_radius(samples, radius, count.ring_width);
  return result;
}

}  // namespace mpm::analysis
