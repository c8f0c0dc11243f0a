// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/mpm.hpp>
#include <array>

/// Isotropic plasticity with linear hardening on top of the rate-linear elasticity that the framework has.
struct VonMises : mpm::Hypoelastic {
  double yield = 400e6, hardening = 100e6;  ///< Pa

  template <class V>
  struct State {
    mpm::SymmetricTensor<V> stress{};  ///< Cauchy stress, Pa
    V plastic_strain{};                ///< accumulated, equivalent
  };
  static constexpr std::array history{"plastic_strain"};

  template <class V>
  State<V> initial() const {
    return {};
  }

  template <class V>
  void update(State<V>& s, const mpm::Increment<V>& step) const {
    mpm::Hypoelastic::State<V> trial{s.stress};
    mpm::Hypoelastic::update(trial, step);
    const V three_G(3 * mpm::shear_modulus(young, poisson));
    const V q = mpm::equivalent_stress(trial.stress);
    const V beyond = mpm::max(q - V(yield) - V(hardening) * s.plastic_strain, V(0));
    const V flow = beyond / (three_G + V(hardening));
    s.stress = trial.stress - (three_G * flow / mpm::max(q, V(yield))) * mpm::deviator(trial.stress);
    s.plastic_strain += flow;
  }

  template <class V>
  mpm::Moduli<V> tangent(const State<V>& s, const V& J) const {
    return mpm::Hypoelastic::tangent(mpm::Hypoelastic::State<V>{s.stress}, J);
  }
};

inline VonMises copper() {
  return {{.density = 8930, .young = 117e9, .poisson = .35}, 400e6, 100e6};
}
