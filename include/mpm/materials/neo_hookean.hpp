// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/material.hpp>
#include <mpm/materials/elastic_moduli.hpp>
#include <mpm/materials/principal.hpp>
#include <array>

namespace mpm {

/// Compressible neo-Hookean solid, P = lambda ln J F^-T + mu (F - F^-T), so sigma = [lambda ln J I + mu (b - I)]/J
/// with b = F F^T. Derived from a potential: a closed cycle is free of work at any strain.
struct NeoHookean {
  double density = 1000;  ///< rho0, kg/m3
  double young = 1e9;     ///< Young's modulus E at rest, Pa
  double poisson = 0;     ///< Poisson's ratio nu at rest

  static constexpr bool needs_deformation_gradient = true;

  template <class V>
  struct State {
    SymmetricTensor<V> stress{};  ///< Cauchy stress, Pa
  };
  static constexpr std::array<const char*, 0> history{};

  template <class V>
  State<V> initial() const {
    return {};
  }

  template <class V>
  void update(State<V>& s, const Increment<V>& step) const {
    const V lambda(lame_modulus(young, poisson)), mu(shear_modulus(young, poisson));
    const auto b = symmetric(step.F * transpose(step.F));
    const V inverse = V(1) / step.J;
    s.stress = inverse * (mu * b + SymmetricTensor<V>::spherical(lambda * log(step.J) - mu));
  }

  /// A plane wave along n sees the acoustic tensor {[lambda (1 - ln J) + mu] n (x) n + mu (n.b.n) I}/J; its largest
  /// value over all n needs only the largest principal value of b, which the stress still holds.
  template <class V>
  Moduli<V> tangent(const State<V>& s, const V& J) const {
    const V lambda(lame_modulus(young, poisson)), mu(shear_modulus(young, poisson));
    const V log_J = log(J), largest = principal_values(s.stress).first;
    const V shear = max(J * largest - lambda * log_J + mu, V(0));
    return {(max(lambda * (V(1) - log_J) + mu, V(0)) + shear) / J, shear / J};
  }
};
static_assert(Material<NeoHookean> && !Fluid<NeoHookean> && needs_deformation_gradient<NeoHookean>);

}  // namespace mpm
