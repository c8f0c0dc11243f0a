// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/material.hpp>
#include <mpm/materials/bulk_viscosity.hpp>
#include <mpm/materials/elastic_moduli.hpp>
#include <array>
#include <stdexcept>

namespace mpm {

/// Brittle material under high pressure after Johnson & Holmquist (1994), "JH-2": pressure-dependent strength that
/// falls from intact to fractured with the damage D, a cubic equation of state, and bulking (the elastic energy lost
/// to damage returns as pressure). Stress pressures are normalised by `p_hel`, strengths by `sigma_hel`. Plastic strain
/// is what exceeds the strength at the old damage; the stress returned is the strength at the new one.
/// The bulk viscosity is part of the stress handed to the grid, never of the strength.
struct JohnsonHolmquist2 {
  double density = 2660;                  ///< rho0, kg/m3
  double young = 50e9, poisson = .2;      ///< E in Pa and nu; they give only the shear modulus, K1 gives the bulk
  double K1 = 27e9, K2 = 0, K3 = 0;       ///< P = K1 mu + K2 mu^2 + K3 mu^3 (mu >= 0), K1 mu (mu < 0); Pa
  double A = .8, N = .6, B = .3, M = .6;  ///< intact A (P* + T*)^N, fractured B P*^M
  double C = 0, reference_rate = 1;       ///< rate factor 1 + C ln(rate/reference); 1/s
  double smax_fracture = 1e20;            ///< cap of the fractured strength, normalised
  double tensile_pressure = 50e6;         ///< T, the largest hydrostatic tension, Pa
  double sigma_hel = 1e9, p_hel = 3e9;    ///< equivalent stress and pressure at the Hugoniot elastic limit, Pa
  double D1 = .01, D2 = 1;                ///< plastic strain to fracture D1 (P* + T*)^D2
  double beta = 1;                        ///< fraction of the lost elastic energy that bulks
  BulkViscosity viscosity{};

  template <class V>
  struct State {
    SymmetricTensor<V> stress{};  ///< Cauchy stress, bulk viscosity included, Pa
    V damage{};                   ///< D, 0 intact to 1 fractured
    V bulking{};                  ///< pressure of bulking, Pa
  };
  static constexpr std::array history{"damage", "bulking"};

  template <class V>
  State<V> initial() const {
    return {};
  }

  template <class V>
  void update(State<V>& s, const Increment<V>& step) const {
    return_to_strength(s, elastic_trial(s.stress, s.bulking, step), step);
  }

  /// The elastic moduli, and what can exceed them: flow is isochoric while the strength rises with pressure, at most
  /// by y' = max(N, M) q/(P + T (1 - D)) a pascal, and maximising over the directions of wave and deviator the tangent
  /// at yield reaches K + 4G/3 + (K y')^2/12G. Shear as in Hypoelastic.
  template <class V>
  Moduli<V> tangent(const State<V>& s, const V& J) const {
    const V q = equivalent_stress(s.stress), K = pressure_slope(V(1) / J - V(1)) / J;
    const V above_cap = trace(s.stress) * V(-1.0 / 3) + V(tensile_pressure) * (V(1) - s.damage);
    const V slope = min(V(max(N, M)) * q / max(above_cap, V(1e-30)), V(3));
    return {K + V(4.0 / 3 * shear()) + K * K * slope * slope * V(1 / (12 * shear())),
            V(shear()) + V(0.57735026918962576) * q};
  }

  double shear() const { return shear_modulus(young, poisson); }

  /// Pressure of the equation of state at the compression mu = 1/J - 1, without bulking, Pa.
  template <class V>
  V pressure(const V& mu) const {
    const V squeezed = max(mu, V(0));
    return V(K1) * mu + squeezed * squeezed * (V(K2) + squeezed * V(K3));
  }
  /// Its slope dP/dmu, Pa.
  template <class V>
  V pressure_slope(const V& mu) const {
    const V squeezed = max(mu, V(0));
    return V(K1) + squeezed * (V(2 * K2) + squeezed * V(3 * K3));
  }

  /// Inverse of `pressure`: the relative volume J at which the equation of state gives p. Throws std::domain_error
  /// where it gives p nowhere.
  double relative_volume(double p) const;

  /// The stress were the step elastic: deviator turned and loaded, pressure from J and bulking, nothing capped. Only
  /// the deviator of `stress` enters.
  template <class V>
  SymmetricTensor<V> elastic_trial(const SymmetricTensor<V>& stress, const V& bulking, const Increment<V>& step) const {
    const auto strain = step.dt * symmetric(step.L);
    return turned(deviator(stress), step.L, step.dt) + V(2 * shear()) * deviator(strain) -
           SymmetricTensor<V>::spherical(pressure(V(1) / step.J - V(1)) + bulking);
  }

  /// What the strength is at least, Pa, without a power: x^N is above the smaller of x and 1 while 0 <= N <= 1, and
  /// rate and fractured strength only add.
  template <class V>
  V certain_strength(const V& reach, const V& damage) const {
    return N >= 0 && N <= 1 && C >= 0 ? V(A * sigma_hel) * (V(1) - damage) * min(reach, V(1)) : V(0);
  }

  /// Brings `trial` back to the strength, updates damage and bulking, sets the stress. Returns the factor that the
  /// deviator was scaled by: 1 where the step was elastic.
  template <class V>
  V return_to_strength(State<V>& s, const SymmetricTensor<V>& trial, const Increment<V>& step) const {
    const V one(1), P = max(trace(trial) * V(-1.0 / 3), V(-tensile_pressure) * (one - s.damage));
    const V reach = max((P + V(tensile_pressure)) * V(1 / p_hel), V(0));
    const V q = equivalent_stress(trial);
    V y = q, left = q, damage = s.damage;
    // Most rock is far from yield: powers are worked out only where the strength may matter.
    if (any(q > certain_strength(reach, s.damage))) {
      V rate_factor = one;
      if (C != 0) {
        const auto D = deviator(symmetric(step.L));
        const V rate = sqrt(V(2.0 / 3) * inner(D, D));
        rate_factor += V(C) * log(max(rate, V(reference_rate)) * V(1 / reference_rate));
      }
      const V pushed = max(P * V(1 / p_hel), V(0)), log_reach = log(reach);
      const V intact = V(A) * power(reach, log_reach, N) * rate_factor;
      const V fractured = min(V(B) * power(pushed, log(pushed), M) * rate_factor, V(smax_fracture));
      const auto strength = [&](const V& d) { return max(intact - d * (intact - fractured), V(0)) * V(sigma_hel); };
      y = strength(s.damage);
      const V plastic = max(q - y, V(0)) * V(1 / (3 * shear()));
      const V to_fracture = max(V(D1) * power(reach, log_reach, D2), V(1e-6));  // the floor breaks at once where P = -T
      damage = min(one, s.damage + plastic / to_fracture);
      left = strength(damage);
    }

    const V mu = V(1) / step.J - one, elastic = V(K1) * max(mu, V(0));
    const V factor = select(q > left, left / max(q, V(1e-30)), one);
    const V lost = max(y * y - left * left, V(0)) * V(1 / (6 * shear()));
    const V bulked = sqrt((elastic + s.bulking) * (elastic + s.bulking) + V(2 * beta * K1) * lost) - elastic;
    s.bulking = select(elastic > V(0), select(damage > s.damage, bulked, s.bulking), s.bulking);
    s.damage = damage;

    const V c = sqrt((pressure_slope(mu) / step.J + V(4.0 / 3 * shear())) * step.J * V(1 / density));
    const V viscous = viscosity.pressure(V(density) / step.J, c, trace(step.L), step.cell);
    s.stress = factor * deviator(trial) - SymmetricTensor<V>::spherical(P + viscous);
    return factor;
  }

 private:
  /// x^n of an x that is not negative, from its logarithm.
  template <class V>
  static V power(const V& x, const V& log_x, double n) {
    return n == 1 ? x : select(x > V(0), exp(V(n) * log_x), V(n > 0 ? 0 : 1));
  }
};
static_assert(Material<JohnsonHolmquist2> && !Fluid<JohnsonHolmquist2>);

inline double JohnsonHolmquist2::relative_volume(double p) const {
  if (!(p > -K1)) throw std::domain_error("JohnsonHolmquist2: no relative volume has a pressure of -K1 or below");
  if (p <= 0) return 1 / (1 + p / K1);
  double low = 0, high = 1e-3;
  while (high < 1e6 && pressure(high) < p) high *= 2;
  if (!(pressure(high) >= p)) throw std::domain_error("JohnsonHolmquist2: the pressure is never reached");
  for (int i = 0; i < 200 && low < high; ++i) {
    const double mu = (low + high) / 2;
    (pressure(mu) < p ? low : high) = mu;
  }
  return 1 / (1 + high);
}

}  // namespace mpm
