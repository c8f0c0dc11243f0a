// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/locate.hpp>
#include <type_traits>

// Particles to nodes, those of the grid or a body's own corners. Each pass adds to the nodes in a fixed order whatever
// the number of threads.
namespace mpm {

/// m_I += w_Ip m_p and (m v)_I += w_Ip m_p v_p.
template <class Body, class Nodes, class Field>
void scatter_momentum(const Body& body, const ParticleOrder& order, Nodes& nodes, Field& momentum) {
  for_each_coloured(order, [&](std::size_t p) {
    const auto stencil = make_stencil(body, p, nodes);
    const auto m = body.mass()[p];
    const typename Field::value_type mv = m * body.velocity(p);
    for (const auto& [I, w, grad] : stencil) {
      nodes.mass[I] += w * m;
      momentum[I] += w * mv;
    }
  });
}

/// m_I += w_Ip m_p.
template <class Body, class Nodes>
void scatter_mass(const Body& body, const ParticleOrder& order, Nodes& nodes) {
  for_each_coloured(order, [&](std::size_t p) {
    const auto stencil = make_stencil(body, p, nodes);
    for (const auto& [I, w, grad] : stencil) nodes.mass[I] += w * body.mass()[p];
  });
}

/// out_I += sum_p w_Ip m_p sum_J w_Jp in_J: a nodal field as the particles see it, back on the nodes as a momentum.
template <class Body, class Nodes, class Field>
void scatter_interpolated(const Body& body, const ParticleOrder& order, const Nodes& nodes, const Field& in,
                          Field& out) {
  using Value = typename Field::value_type;
  for_each_coloured(order, [&](std::size_t p) {
    const auto stencil = make_stencil(body, p, nodes);
    Value seen = Value::Zero();
    for (const auto& [I, w, grad] : stencil) seen += w * in[I];
    seen *= body.mass()[p];
    for (const auto& [I, w, grad] : stencil) out[I] += w * seen;
  });
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
void scatter_force(const Body& body, const ParticleOrder& order, Nodes& nodes, const Force& body_force, double time) {
  using S = typename Body::SpaceType;
  for_each_coloured(order, [&](std::size_t p) {
    const auto stencil = make_stencil(body, p, nodes);
    const auto stress = body.stress(p);
    const auto volume = body.volume()[p], radius = body.x(0)[p];
    const Vector<S> weight = body.mass()[p] * body_force(body, p, time);
    for (const auto& [I, w, grad] : stencil)
      nodes.increment[I] += w * weight - stress_flux<S>(stress, volume, radius, w, grad);
  });
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
