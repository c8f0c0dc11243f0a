// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/locate.hpp>
#include <limits>
#include <type_traits>

// Particles to nodes, those of the grid or a body's own corners. Each pass adds to the nodes in a fixed order whatever
// the number of threads.
namespace mpm {

/// What a pass gives to the nodes.
enum class What { mass, momentum, forces, mass_and_forces, momentum_and_forces };
template <What what>
inline constexpr bool gives_mass = what != What::forces;
template <What what>
inline constexpr bool gives_momentum = what == What::momentum || what == What::momentum_and_forces;
template <What what>
inline constexpr bool gives_forces = what != What::mass&& what != What::momentum;

/// m_I += w_Ip m_p and (m v)_I += w_Ip m_p v_p of one particle.
template <class Body, class Nodes, class Field>
void add_momentum(const Body& body, std::size_t p, Nodes& nodes, Field& momentum) {
  const auto stencil = make_stencil(body, p, nodes);
  const auto m = body.mass()[p];
  const typename Field::value_type mv = m * body.velocity(p);
  for (const auto& [I, w, grad] : stencil) {
    nodes.mass[I] += w * m;
    momentum[I] += w * mv;
  }
}

/// m_I += w_Ip m_p.
template <class Body, class Nodes>
void add_mass(const Body& body, std::size_t p, Nodes& nodes) {
  const auto stencil = make_stencil(body, p, nodes);
  for (const auto& [I, w, grad] : stencil) nodes.mass[I] += w * body.mass()[p];
}

/// out_I += sum_p w_Ip m_p sum_J w_Jp in_J: a nodal field as the particles see it, back on the nodes as a momentum.
/// Of one particle, and of all.
template <class Body, class Nodes, class Field>
void scatter_interpolated(const Body& body, std::size_t p, const Nodes& nodes, const Field& in, Field& out) {
  using Value = typename Field::value_type;
  const auto stencil = make_stencil(body, p, nodes);
  Value seen = Value::Zero();
  for (const auto& [I, w, grad] : stencil) seen += w * in[I];
  seen *= body.mass()[p];
  for (const auto& [I, w, grad] : stencil) out[I] += w * seen;
}
template <class Body, class Nodes, class Field>
void scatter_interpolated(const Body& body, const ParticleOrder& order, const Nodes& nodes, const Field& in,
                          Field& out) {
  for_each_coloured(order, [&](std::size_t p) { scatter_interpolated(body, p, nodes, in, out); });
}

/// V sigma grad w: minus the force of one particle on one node (Eq 9 of Xiao et al. 2024). In a space with a hoop
/// direction sigma_zz acts through w / r.
template <class S, class Stress, class Scalar = typename S::Scalar>
Vector<S> stress_flux(const Stress& s, Scalar volume, Scalar radius, Scalar w,
                      const std::array<Scalar, S::dimension>& g) {
  Vector<S> f;
  if constexpr (S::dimension == 1) {
    f[0] = s.xx * g[0];
  } else if constexpr (S::dimension == 2) {
    f[0] = s.xx * g[0] + s.xy * g[1];
    f[1] = s.xy * g[0] + s.yy * g[1];
  } else {
    f[0] = s.xx * g[0] + s.xy * g[1] + s.zx * g[2];
    f[1] = s.xy * g[0] + s.yy * g[1] + s.yz * g[2];
    f[2] = s.zx * g[0] + s.yz * g[1] + s.zz * g[2];
  }
  if constexpr (S::hoop) f[0] += s.zz * w / radius;
  return volume * f;
}

/// f_I += -V sigma grad w + w m b.
template <class Body, class Nodes, class Force>
void add_force(const Body& body, std::size_t p, Nodes& nodes, const Force& body_force, double time) {
  using S = typename Body::SpaceType;
  const auto stencil = make_stencil(body, p, nodes);
  const auto stress = body.stress(p);
  const auto volume = body.volume()[p], radius = body.x(0)[p];
  const Vector<S> weight = body.mass()[p] * body_force(body, p, time);
  for (const auto& [I, w, grad] : stencil)
    nodes.increment[I] += w * weight - stress_flux<S>(stress, volume, radius, w, grad);
}

/// First of the `valid` particles from p on whose stress is no finite number, or the largest size_t. With lanes for V,
/// the whole register is looked at once.
template <class V, class Body>
std::size_t first_unsound(const Body& body, std::size_t p, int valid) {
  const auto s = body.template stress<V>(p);
  const V nothing = V(0) * (s.xx + s.yy + s.zz + s.xy + s.yz + s.zx);
  if (any(!(nothing <= V(0))))
    for (int k = 0; k < valid; ++k)
      if (!(lane(nothing, k) <= 0)) return p + std::size_t(k);
  return std::numeric_limits<std::size_t>::max();
}

/// Everything that a pass gives, of one particle. Returns p if forces come from a stress that is no finite number, else
/// the largest size_t.
template <What what, class Body, class Nodes, class Field, class Force>
std::size_t scatter_plainly(const Body& body, std::size_t p, Nodes& nodes, Field& momentum, const Force& body_force,
                            double time) {
  if constexpr (gives_momentum<what>) {
    add_momentum(body, p, nodes, momentum);
  } else if constexpr (gives_mass<what>) {
    add_mass(body, p, nodes);
  }
  if constexpr (gives_forces<what>) {
    add_force(body, p, nodes, body_force, time);
    return first_unsound<typename Body::Scalar>(body, p, 1);
  } else {
    return std::numeric_limits<std::size_t>::max();
  }
}

/// Sum of abs(V sigma grad w) a node: the scale that an unbalanced force is held against (Eq 31, corrected).
template <class Body, class S>
void scatter_force_scale(const Body& body, const ParticleOrder& order, const Grid<S>& grid,
                         std::vector<typename S::Scalar>& scale) {
  for_each_coloured(order, [&](std::size_t p) {
    const auto stencil = make_stencil(body, p, grid);
    const auto stress = body.stress(p);
    const auto volume = body.volume()[p], radius = body.x(0)[p];
    for (const auto& [I, w, grad] : stencil) scale[I] += stress_flux<S>(stress, volume, radius, w, grad).norm();
  });
}

}  // namespace mpm
