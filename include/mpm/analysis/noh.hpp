// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/gas_state.hpp>
#include <cmath>
#include <stdexcept>

namespace mpm::analysis {

/// Noh's implosion (Noh 1987, J. Comput. Phys. 72, 78): a cold ideal gas runs at one speed everywhere against a wall,
/// an axis or a centre, and an infinitely strong shock moves out at (gamma - 1)/2 of that speed.
struct Noh {
  int dimension{1};      ///< 1 wall, 2 axis, 3 centre
  double gamma{5. / 3};  ///< ratio of heat capacities, > 1
  double density{1};     ///< rho0 at t = 0, kg/m3
  double speed{1};       ///< u0 of the inflow, m/s

  /// Radius of the shock at time t, m.
  double shock(double t) const { return 0.5 * (gamma - 1) * speed * t; }

  /// State at radius r > 0 (m) and time t >= 0 (s); behind the shock the gas rests at rho0 ((gamma + 1)/(gamma - 1))^d,
  /// its internal energy u0^2/2. Throws std::invalid_argument for parameters out of range.
  GasState at(double r, double t) const {
    if (!(dimension >= 1 && dimension <= 3 && gamma > 1 && density > 0 && speed > 0 && r > 0 && t >= 0))
      throw std::invalid_argument(
          "Noh: dimension must be 1, 2 or 3, gamma > 1, t >= 0, and density, speed and r positive");
    if (r >= shock(t)) return {density * std::pow(1 + speed * t / r, dimension - 1), -speed, 0};
    const double compressed = density * std::pow((gamma + 1) / (gamma - 1), dimension);
    return {compressed, 0, 0.5 * (gamma - 1) * compressed * speed * speed};
  }
};

}  // namespace mpm::analysis
