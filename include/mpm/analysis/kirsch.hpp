// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/polar.hpp>
#include <cmath>

namespace mpm::analysis {

/// Displacement in polar components, m.
struct PolarDisplacement {
  double r{}, t{};
};

/// Kirsch (1898): a traction-free circular hole in an infinite linear elastic plate under far-field stress.
///
/// Eq 12 of Xiao et al. 2024, Processes 12, 1048, corrected: the shear goes with sin 2 theta, theta is measured from
/// x, and tension is positive, so that rock under compression has negative far-field stresses. The centre is the
/// origin; valid for r >= radius.
struct Kirsch {
  double horizontal{};  ///< principal far-field stress in `direction`, Pa
  double vertical{};    ///< the one across it, Pa
  double radius{1};     ///< of the hole, m
  double direction{};   ///< of `horizontal`, rad from x, counter-clockwise

  /// Stress far from the hole.
  PlanarStress far_field() const { return to_cartesian({horizontal, vertical, 0}, direction); }

  /// Stress at (r, theta), m and rad. At the wall the hoop stress is 3 vertical - horizontal in `direction` and
  /// 3 horizontal - vertical across it.
  PolarStress polar_stress(double r, double theta) const {
    const double q2 = (radius / r) * (radius / r), q4 = q2 * q2;
    const double off = theta - direction, c = deviator() * std::cos(2 * off), s = deviator() * std::sin(2 * off);
    return {mean() * (1 - q2) + c * (1 - 4 * q2 + 3 * q4), mean() * (1 + q2) - c * (1 + 3 * q4),
            -s * (1 + 2 * q2 - 3 * q4)};
  }

  /// Stress at the point (x, y), m.
  PlanarStress stress(double x, double y) const {
    const double theta = std::atan2(y, x);
    return to_cartesian(polar_stress(std::hypot(x, y), theta), theta);
  }

  /// Out-of-plane stress at (x, y) in plane strain, Pa.
  double stress_zz(double x, double y, double poisson) const {
    const PlanarStress s = stress(x, y);
    return poisson * (s.xx + s.yy);
  }

  /// Displacement at (r, theta) that cutting the hole adds to the pre-stressed rock (zero far away); plane strain,
  /// `shear_modulus` in Pa.
  PolarDisplacement displacement(double r, double theta, double shear_modulus, double poisson) const {
    const double q2 = (radius / r) * (radius / r), f = r * q2 / (2 * shear_modulus), off = theta - direction;
    return {f * (mean() + deviator() * (4 * (1 - poisson) - q2) * std::cos(2 * off)),
            -f * deviator() * (2 * (1 - 2 * poisson) + q2) * std::sin(2 * off)};
  }

 private:
  double mean() const { return 0.5 * (horizontal + vertical); }
  double deviator() const { return 0.5 * (horizontal - vertical); }
};

}  // namespace mpm::analysis
