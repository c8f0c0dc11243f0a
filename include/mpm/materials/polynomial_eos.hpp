// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/material.hpp>
#include <mpm/materials/bulk_viscosity.hpp>
#include <array>

namespace mpm {

/// Linear polynomial equation of state (Xiao et al. 2024, Eq 20),
/// p = c0 + c1 mu + c2 mu^2 + c3 mu^3 + (c4 + c5 mu + c6 mu^2) E, with mu = 1/J - 1 and E the internal energy per
/// initial volume. c4 = c5 = gamma - 1, all else zero, is the ideal gas p = (gamma - 1) E/J. The energy equation is
/// solved with p implicitly, by the trapezoid of the pressure the grid sees.
struct PolynomialEos {
  double density = 1.225;                 ///< rho0, kg/m3
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0;  ///< cold curve, Pa
  double c4 = .4, c5 = .4, c6 = 0;        ///< Grueneisen part, dimensionless
  double initial_energy = 250e3;          ///< E at the start, J/m3
  BulkViscosity viscosity{};

  template <class V>
  struct State {
    V pressure{};  ///< compression positive, bulk viscosity included, Pa
    V energy{};    ///< internal energy per initial volume, J/m3
  };
  static constexpr std::array history{"energy"};

  template <class V>
  State<V> initial() const {
    return {V(c0 + c4 * initial_energy), V(initial_energy)};
  }

  template <class V>
  void update(State<V>& s, const Increment<V>& step) const {
    const V density_now = V(density) / step.J;
    const V c = sqrt(tangent(s, step.J_old).longitudinal * step.J_old / V(density));
    const V q = viscosity.pressure(density_now, c, trace(step.L), step.cell);
    const V mu = V(1) / step.J - V(1), dV = step.J - step.J_old;
    const V a = cold(mu), b = grueneisen(mu);
    s.energy = (s.energy - V(0.5) * dV * (s.pressure + a + q)) / (V(1) + V(0.5) * dV * b);
    s.pressure = a + b * s.energy + q;
  }

  /// Isentropic bulk modulus -V dp/dV at dE = -p dV.
  template <class V>
  Moduli<V> tangent(const State<V>& s, const V& J) const {
    const V mu = V(1) / J - V(1), b = grueneisen(mu);
    const V slope = V(c1) + mu * (V(2 * c2) + mu * V(3 * c3)) + (V(c5) + V(2 * c6) * mu) * s.energy;
    return {max(slope / J + J * b * (cold(mu) + b * s.energy), V(0)), V(0)};
  }

 private:
  template <class V>
  V cold(const V& mu) const {
    return V(c0) + mu * (V(c1) + mu * (V(c2) + mu * V(c3)));
  }
  template <class V>
  V grueneisen(const V& mu) const {
    return V(c4) + mu * (V(c5) + mu * V(c6));
  }
};
static_assert(Fluid<PolynomialEos> && !needs_deformation_gradient<PolynomialEos>);

}  // namespace mpm
