// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/gather.hpp>
#include <cmath>

namespace mpm {

/// Strains every particle with the nodal velocities, moves its volume (and F) along, and calls the law.
///
/// With Move the particle then rides the nodes, x_p += dt sum w_Ip v_I, with the very weights that strained it: those
/// of its new domain may rest on nodes that hold next to nothing.
///
/// In MUSL `velocity` is the remapped field. The work V sigma : D dt is added up in a fixed order. Returns the first
/// particle whose volume or stress is no longer a finite positive number, or body.size().
template <bool Move, class Body, class Nodes, class S = typename Body::SpaceType>
std::size_t update_stress(Body& body, const Nodes& nodes, const std::vector<Vector<S>>& velocity,
                          typename S::Scalar cell, typename S::Scalar time, typename S::Scalar dt,
                          std::vector<double>& partial) {
  using Scalar = typename S::Scalar;
  constexpr std::int64_t chunk = 256;
  const std::int64_t count = std::int64_t(body.size()), chunks = (count + chunk - 1) / chunk;
  partial.resize(std::size_t(chunks));
  std::int64_t bad = count;
#pragma omp parallel for schedule(static) reduction(min : bad)
  for (std::int64_t c = 0; c < chunks; ++c) {
    double work = 0;
    for (std::int64_t q = c * chunk; q < std::min(count, (c + 1) * chunk); ++q) {
      const std::size_t p = std::size_t(q);
      const auto stencil = make_stencil(body, p, nodes);
      const auto L = velocity_gradient<S>(stencil, velocity, body.x(0)[p]);
      const auto step = Tensor<Scalar>::identity() + dt * L;
      const Scalar old_volume = body.volume()[p], new_volume = old_volume * determinant(step);
      Increment<Scalar> increment{.L = L, .dt = dt, .time = time + dt, .size = body.particle_size(p), .cell = cell};
      increment.J_old = body.relative_volume(p);
      increment.J = increment.J_old * determinant(step);
      if constexpr (Body::stores_F) {
        increment.F = step * body.F(p);
        body.store_F(p, increment.F);
      }
      auto state = body.state(p);
      const auto old_stress = body.stress(p);
      body.law.update(state, increment);
      body.store(p, state);
      if constexpr (Body::Shape::domain_motion != DomainMotion::corners) body.volume()[p] = new_volume;
      const auto mean = Scalar(0.5) * (old_stress + body.stress(p));
      const Scalar w = Scalar(0.5) * (old_volume + new_volume) * inner(mean, symmetric(L)) * dt;
      if (!(new_volume > 0) || !std::isfinite(w)) bad = std::min(bad, q);
      work += double(w);
      if constexpr (Move) {
        const Vector<S> v = interpolate<S>(stencil, nodes.velocity);
        for (int d = 0; d < S::dimension; ++d) body.x(d)[p] += dt * v[d];
      }
    }
    partial[std::size_t(c)] = work;
  }
  double work = 0;
  for (double w : partial) work += w;
  body.stress_work += work;
  return std::size_t(bad);
}

}  // namespace mpm
