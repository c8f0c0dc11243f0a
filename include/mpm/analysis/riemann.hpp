// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/gas_state.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace mpm::analysis {

/// Speeds (m/s) of the two edges of a wave: `head` meets the gas ahead, `tail` leaves the star region behind. Equal in
/// a shock.
struct RiemannWave {
  double head{}, tail{};
};

/// The region between the two waves: one pressure (Pa) and velocity (m/s), two densities (kg/m3) either side of the
/// contact, which moves with `velocity`.
struct RiemannStar {
  double pressure{}, velocity{}, density_left{}, density_right{};
  RiemannWave left, right;
};

/// Exact solution of the Riemann problem of an ideal gas: `left` of x = 0 and `right` of it at t = 0 (Toro 2009,
/// Riemann Solvers and Numerical Methods for Fluid Dynamics, chapter 4). The defaults are Sod's shock tube.
struct Riemann {
  GasState left{1, 0, 1}, right{.125, 0, .1};
  double gamma{1.4};  ///< ratio of heat capacities, > 1

  /// Star values, to round-off. Throws std::invalid_argument for densities, pressures or gamma out of range, and where
  /// the gases part so fast that a vacuum opens between them.
  RiemannStar star() const {
    check();
    RiemannStar s;
    s.pressure = star_pressure();
    s.velocity = 0.5 * (left.velocity + right.velocity) +
                 0.5 * (velocity_change(right, s.pressure) - velocity_change(left, s.pressure));
    s.density_left = star_density(left, s.pressure);
    s.density_right = star_density(right, s.pressure);
    s.left = wave(left, -1, s.pressure, s.velocity);
    s.right = wave(right, 1, s.pressure, s.velocity);
    return s;
  }

  /// State at x/t, m/s. Throws as `star`.
  GasState at(double speed) const {
    const RiemannStar s = star();
    return speed < s.velocity ? at(speed, left, -1, s.left, {s.density_left, s.velocity, s.pressure})
                              : at(speed, right, 1, s.right, {s.density_right, s.velocity, s.pressure});
  }

 private:
  double sound(const GasState& g) const { return std::sqrt(gamma * g.pressure / g.density); }

  void check() const {
    if (!(gamma > 1 && left.density > 0 && right.density > 0 && left.pressure > 0 && right.pressure > 0))
      throw std::invalid_argument("Riemann: densities and pressures must be positive and gamma > 1");
    const double escape = 2 / (gamma - 1) * (sound(left) + sound(right));
    if (!(right.velocity - left.velocity < escape))
      throw std::invalid_argument("Riemann: a vacuum opens between gases that part at " + std::to_string(escape) +
                                  " m/s or faster; choose closer velocities");
  }

  /// What a wave to the star pressure p adds to the velocity, Toro's f_K: a shock if p is above the gas's own pressure.
  double velocity_change(const GasState& g, double p) const {
    if (p > g.pressure)
      return (p - g.pressure) * std::sqrt(2 / (g.density * ((gamma + 1) * p + (gamma - 1) * g.pressure)));
    return 2 * sound(g) / (gamma - 1) * (std::pow(p / g.pressure, (gamma - 1) / (2 * gamma)) - 1);
  }
  double velocity_slope(const GasState& g, double p) const {
    if (p > g.pressure) {
      const double a = (gamma + 1) * p + (gamma - 1) * g.pressure;
      return std::sqrt(2 / (g.density * a)) * (1 - 0.5 * (gamma + 1) * (p - g.pressure) / a);
    }
    return std::pow(p / g.pressure, -(gamma + 1) / (2 * gamma)) / (g.density * sound(g));
  }

  /// Newton's method from the pressure of two rarefactions. The function is concave and rising, so all iterates after
  /// the first lie below the root and climb.
  double star_pressure() const {
    const double exponent = (gamma - 1) / (2 * gamma), cl = sound(left), cr = sound(right);
    const double drift = right.velocity - left.velocity;
    double p = std::pow((cl + cr - 0.5 * (gamma - 1) * drift) /
                            (cl * std::pow(left.pressure, -exponent) + cr * std::pow(right.pressure, -exponent)),
                        1 / exponent);
    for (int i = 0; i < 100; ++i) {
      const double excess = velocity_change(left, p) + velocity_change(right, p) + drift;
      const double next =
          std::max(0.1 * p, p - excess / (velocity_slope(left, p) + velocity_slope(right, p)));  // never negative
      const bool done = std::abs(next - p) <= 1e-15 * p;
      p = next;
      if (done) break;
    }
    return p;
  }

  double star_density(const GasState& g, double p) const {
    const double ratio = p / g.pressure, q = (gamma - 1) / (gamma + 1);
    return g.density * (ratio > 1 ? (ratio + q) / (q * ratio + 1) : std::pow(ratio, 1 / gamma));
  }

  /// `side` is -1 for the wave to the left and +1 for the one to the right.
  RiemannWave wave(const GasState& g, double side, double p, double u) const {
    const double ratio = p / g.pressure, c = side * sound(g);
    if (ratio > 1) {
      const double shock = g.velocity + c * std::sqrt(((gamma + 1) * ratio + gamma - 1) / (2 * gamma));
      return {shock, shock};
    }
    return {g.velocity + c, u + c * std::pow(ratio, (gamma - 1) / (2 * gamma))};
  }

  GasState at(double speed, const GasState& ahead, double side, const RiemannWave& w, const GasState& behind) const {
    if (side * (speed - w.head) >= 0) return ahead;
    if (side * (speed - w.tail) <= 0) return behind;
    const double u = ahead.velocity + 2 / (gamma + 1) * (speed - w.head);  // inside a rarefaction, u + side c = x/t
    const double ratio = 1 + side * 0.5 * (gamma - 1) * (u - ahead.velocity) / sound(ahead);
    return {ahead.density * std::pow(ratio, 2 / (gamma - 1)), u,
            ahead.pressure * std::pow(ratio, 2 * gamma / (gamma - 1))};
  }
};

}  // namespace mpm::analysis
