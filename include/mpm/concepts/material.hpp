// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/tensor.hpp>
#include <concepts>
#include <type_traits>

namespace mpm {

/// What a law is told about one step of one particle. Tension positive, SI units.
template <class V>
struct Increment {
  Tensor<V> L{};                        ///< velocity gradient over the step, 1/s; always 3x3 (the space lifts it)
  Tensor<V> F = Tensor<V>::identity();  ///< deformation gradient at the step's end; only for laws that ask for it
  V J{1};                               ///< relative volume V/V0 = density/rho at the step's end
  V J_old{1};                           ///< and at its start
  V dt{};                               ///< step, s
  V time{};                             ///< time at the step's end, s
  V size{};                             ///< size of the particle, m (fracture energy: l_c)
  V cell{};                             ///< cell of the grid, m (bulk viscosity: h)
};

/// Tangent moduli, Pa: longitudinal K + 4G/3 and shear G. The step is taken from these, never from constants.
template <class V>
struct Moduli {
  V longitudinal{};
  V shear{};
};

/// MATERIAL: a constitutive law.
///
/// A plain aggregate of its parameters (double, SI) with default member initialisers. It knows no grid, no dimension,
/// no neighbour and no position. It has
///   - `density`: the reference density rho0, kg/m3, at relative volume J = 1;
///   - `State<V>`: what one particle carries, an aggregate of V only. Its first member is `SymmetricTensor<V> stress`,
///     or, for a fluid whose whole stress is one number, `V pressure` (compression positive);
///   - `history`: the names of the members behind the first, in order (an array of `const char*`, may be empty);
///   - `initial<V>()`: the state at J = 1 and rest;
///   - `update(state, increment)`: the state at the step's end. Objective: a superposed rotation turns the stress;
///   - `tangent(state, J)`: the moduli that bound the speed of sound in that state;
///   - optional `static constexpr bool needs_deformation_gradient = true`: F is stored and passed.
/// `update` and `tangent` are templates on the lane type V (see tensor.hpp) and branch-free.
template <class M>
concept Material = std::is_aggregate_v<M> &&
    requires(const M law, typename M::template State<double> state, const Increment<double> step, double J) {
  { law.density } -> std::convertible_to<double>;
  { M::history.size() } -> std::convertible_to<std::size_t>;
  { law.template initial<double>() } -> std::same_as<typename M::template State<double>>;
  law.update(state, step);
  { law.tangent(state, J) } -> std::same_as<Moduli<double>>;
};

/// A law whose whole stress is a pressure.
template <class M>
concept Fluid = Material<M> && requires(typename M::template State<double> s) {
  s.pressure;
};

/// A law that asks for the deformation gradient.
template <class M>
inline constexpr bool needs_deformation_gradient = requires {
  requires M::needs_deformation_gradient;
};

}  // namespace mpm
