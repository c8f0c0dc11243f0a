// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/material.hpp>
#include <mpm/materials/elastic_moduli.hpp>
#include <array>

namespace mpm {

/// Rate-linear elasticity: sigma+ = Q sigma Q^T + C : D dt with the step rotation Q of Hughes & Winget (1980), that is
/// isotropic elasticity under the Jaumann rate. Linear elastic for small strains; for large ones a closed cycle is
/// not exactly free of work: take NeoHookean there.
struct Hypoelastic {
  double density = 1000;  ///< rho0, kg/m3
  double young = 1e9;     ///< Young's modulus E, Pa
  double poisson = 0;     ///< Poisson's ratio nu

  template <class V>
  struct State {
    SymmetricTensor<V> stress{};  ///< Cauchy stress, Pa
  };
  static constexpr std::array<const char*, 0> history{};

  template <class V>
  State<V> initial() const {
    return {};
  }

  /// Inlined by force: a pass of each shape calls it, and the call costs more than the law.
  template <class V>
  [[gnu::always_inline]] void update(State<V>& s, const Increment<V>& step) const {
    const V lambda(lame_modulus(young, poisson)), two_mu(2 * shear_modulus(young, poisson));
    const auto strain = step.dt * symmetric(step.L);
    s.stress =
        turned(s.stress, step.L, step.dt) + two_mu * strain + SymmetricTensor<V>::spherical(lambda * trace(strain));
  }

  /// A longitudinal wave has no spin, so lambda + 2 mu holds in every state; the Jaumann rate adds half a difference
  /// of principal stresses, at most q/sqrt 3, to the stiffness of a shear wave.
  template <class V>
  Moduli<V> tangent(const State<V>& s, const V&) const {
    const double mu = shear_modulus(young, poisson);
    return {V(lame_modulus(young, poisson) + 2 * mu), V(mu) + V(0.57735026918962576) * equivalent_stress(s.stress)};
  }
};
static_assert(Material<Hypoelastic> && !Fluid<Hypoelastic> && !needs_deformation_gradient<Hypoelastic>);

}  // namespace mpm
