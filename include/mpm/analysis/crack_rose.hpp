// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/crack_measures.hpp>

namespace mpm::analysis {

/// Reach of the damage by direction, m, the radius that holds 98 % of the damaged area of a sector (a sector has few
/// particles, and the lone ones far out are no crack): the circle in `sectors` equal parts, sector k about the
/// direction 2 pi k / sectors from x; zero where a sector holds no damage. With a multiplicity of 4 the samples are a
/// quadrant, which is mirrored. Throws std::invalid_argument as `crack_measures` does, and without a sector.
inline std::vector<double> crack_rose(const DamageSamples& samples, const CrackCount& count, int sectors) {
  check(samples, count);
  if (sectors < 1) throw std::invalid_argument("crack_rose: at least one sector is needed");
  constexpr double share = 0.98;
  const double width = 2 * std::numbers::pi / sectors;
  std::vector<std::vector<detail::RadiusAndArea>> damaged(static_cast<std::size_t>(sectors));
  for (std::size_t i = 0; i < samples.x.size(); ++i) {
    if (!(samples.damage[i] > count.threshold)) continue;
    const double dx = samples.x[i], dy = samples.y[i];
    const auto put = [&](double x, double y) {
      const double turn = std::atan2(y, x) / width + sectors;
      damaged[static_cast<std::size_t>(std::lround(turn)) % damaged.size()].push_back(
          {std::hypot(dx, dy), samples.area[i]});
    };
    put(dx, dy);
    if (count.multiplicity == 4) put(-dx, dy), put(-dx, -dy), put(dx, -dy);
  }
  std::vector<double> reach;
  for (auto& sector : damaged) reach.push_back(detail::radius_holding(share, std::move(sector)));
  return reach;
}

}  // namespace mpm::analysis
