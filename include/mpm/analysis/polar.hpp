// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

namespace mpm::analysis {

/// In-plane stress in polar components about some centre, Pa, tension positive.
struct PolarStress {
  double rr{}, tt{}, rt{};
};

/// In-plane stress in Cartesian components, Pa, tension positive.
struct PlanarStress {
  double xx{}, yy{}, xy{};
};

/// Polar components of a Cartesian stress at a point whose radius makes the angle `theta` (rad) with x.
inline PolarStress to_polar(const PlanarStress& s, double theta) {
  const double mean = 0.5 * (s.xx + s.yy), half = 0.5 * (s.xx - s.yy);
  const double c = std::cos(2 * theta), d = std::sin(2 * theta);
  return {mean + half * c + s.xy * d, mean - half * c - s.xy * d, s.xy * c - half * d};
}

/// Cartesian components of a polar stress; the inverse of `to_polar`.
inline PlanarStress to_cartesian(const PolarStress& s, double theta) {
  const PolarStress back = to_polar({s.rr, s.tt, s.rt}, -theta);
  return {back.rr, back.tt, back.rt};
}

}  // namespace mpm::analysis
