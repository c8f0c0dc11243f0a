// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/locate.hpp>

// Nodes, those of the grid or a body's own corners, to particles.
namespace mpm {

/// Sum w_Ip v_I of a nodal vector field.
template <class S, class Out>
Vector<S> interpolate(const Out& stencil, const std::vector<Vector<S>>& field) {
  Vector<S> value = Vector<S>::Zero();
  for (const auto& [I, w, grad] : stencil) value += w * field[I];
  return value;
}

/// Velocity gradient sum v_I (x) grad w_Ip, lifted to 3x3 (v_r / r in the hoop direction).
template <class S, class Out>
Tensor<typename S::Scalar> velocity_gradient(const Out& stencil, const std::vector<Vector<S>>& velocity,
                                             typename S::Scalar radius) {
  using Scalar = typename S::Scalar;
  constexpr int dimension = S::dimension;
  Scalar g[3][3] = {};
  Scalar hoop = 0;
  for (const auto& [I, w, grad] : stencil) {
    const auto& v = velocity[I];
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < dimension; ++j) g[i][j] += v[i] * grad[j];
    if constexpr (S::hoop) hoop += w * v[0];
  }
  if constexpr (S::hoop) g[2][2] = hoop / radius;
  return {g[0][0], g[0][1], g[0][2], g[1][0], g[1][1], g[1][2], g[2][0], g[2][1], g[2][2]};
}

/// v_p from the nodes, as the integrator blends the increment (FLIP) and the velocity itself (PIC).
template <class Body, class Nodes, class Integrator>
void gather_velocity(Body& body, std::size_t p, const Nodes& nodes, const Integrator& integrator) {
  using S = typename Body::SpaceType;
  const auto stencil = make_stencil(body, p, nodes);
  const Vector<S> increment = interpolate<S>(stencil, nodes.increment), v = interpolate<S>(stencil, nodes.velocity);
  for (int d = 0; d < S::dimension; ++d) body.v(d)[p] = integrator.particle_velocity(body.v(d)[p], v[d], increment[d]);
}
template <class Body, class Nodes, class Integrator>
void gather_velocity(Body& body, const ChunkList& chunks, const Nodes& nodes, const Integrator& integrator) {
  chunks.for_each_entry([&](std::size_t p) { gather_velocity(body, p, nodes, integrator); });
}

}  // namespace mpm
