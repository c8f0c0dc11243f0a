// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <numbers>

namespace mpm::analysis {

/// Axial bar, fixed at X = 0 and free at X = length, in its lowest mode: at t = 0 unstrained with the velocity
/// `speed` sin(pi X/(2 length)). One-dimensional linear elasticity, so right to first order in speed/wave_speed().
struct AxialBar {
  double length{25};  ///< m
  double young{100};  ///< Pa
  double density{1};  ///< kg/m3
  double speed{0.1};  ///< of the free end at t = 0, m/s

  /// sqrt(E/rho), m/s.
  double wave_speed() const { return std::sqrt(young / density); }
  /// Time of one oscillation, s.
  double period() const { return 4 * length / wave_speed(); }

  /// Displacement at X (m) and time t (s), m.
  double displacement(double X, double t) const {
    return speed / frequency() * std::sin(wave_number() * X) * std::sin(frequency() * t);
  }
  /// m/s.
  double velocity(double X, double t) const { return speed * std::sin(wave_number() * X) * std::cos(frequency() * t); }
  /// Axial stress, Pa, tension positive.
  double stress(double X, double t) const {
    return young * speed / wave_speed() * std::cos(wave_number() * X) * std::sin(frequency() * t);
  }
  /// Total energy per cross-section, kinetic and elastic, J/m2; constant.
  double energy() const { return 0.25 * density * speed * speed * length; }

 private:
  double wave_number() const { return std::numbers::pi / (2 * length); }
  double frequency() const { return wave_number() * wave_speed(); }
};

}  // namespace mpm::analysis
