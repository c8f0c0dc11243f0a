// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/cell_dilatation.hpp>
#include <cmath>
#include <limits>

namespace mpm {

/// Which nodal field strains the particles: the nodes' velocity, which is the first that a pass reads, or the one
/// after.
enum class Strained { none, by_first, by_second };

/// What limits the next step of a chunk of particles: the largest of each, or with lanes for V, of each lane.
template <class V>
struct StepLimits {
  V lambda{0}, shear{0};  ///< moduli over the density and over the squared factor of the viscosity, m2/s2
  V rate{0};              ///< squared norm of the rate of deformation, 1/s2
  V speed{0};             ///< component of the velocity that moves them, m/s
  bool known = false;     ///< from a strain since the particles were ordered

  /// Raises `limit` to `value`; what is no number stays to be found.
  static void raise(V& limit, const V& value) { limit = larger_or_nan(limit, value); }
};
template <class T, int N>
StepLimits<T> over_lanes(const StepLimits<Lanes<T, N>>& l) {
  return {largest(l.lambda), largest(l.shear), largest(l.rate), largest(l.speed), l.known};
}

/// Limits that hold for any particle of the chunks, whichever it is in.
template <class V>
StepLimits<V> over_chunks(const std::vector<StepLimits<V>>& chunks) {
  StepLimits<V> all{.known = !chunks.empty()};
  for (const auto& l : chunks) {
    all.raise(all.lambda, l.lambda), all.raise(all.shear, l.shear);
    all.raise(all.rate, l.rate), all.raise(all.speed, l.speed);
    all.known = all.known && l.known;
  }
  return all;
}

/// A particle rides the nodes: x_p += dt sum w_Ip v_I.
template <class S, class Body, class Out, class Nodes, class Scalar = typename S::Scalar>
void ride(Body& body, std::size_t p, const Out& stencil, const Nodes& nodes, Scalar dt, StepLimits<Scalar>& limits) {
  const Vector<S> v = interpolate<S>(stencil, nodes.velocity);
  for (int d = 0; d < S::dimension; ++d) {
    body.x(d)[p] += dt * v[d];
    limits.raise(limits.speed, std::abs(v[d]));
  }
}

/// What a strain has come to: the work V sigma : D dt, J, and whether volume or stress are no longer a finite positive
/// number.
template <class V>
struct StrainResult {
  V work;
  V viscous;  ///< the part of the work that bulk viscosity took
  decltype(V() < V()) unsound;
};

/// The law of a body as a loop over its particles wants it: a copy where that costs nothing, so that the compiler sees
/// that nothing which the loop stores changes it.
template <class Body, class Law = typename Body::Law>
using LoopLaw = std::conditional_t<std::is_trivially_copyable_v<Law>, const Law, const Law&>;

/// Strains particle p, or with lanes for V those from p on, of which `valid` are meant, with the velocity gradient L
/// over `dt`: volume (and F) follow, and `law`, the body's, gives the stress. Raises `limits`.
template <class V, class Body, class Scalar = typename Body::Scalar>
[[gnu::always_inline]] inline StrainResult<V> strain(Body& body, const typename Body::Law& law, std::size_t p,
                                                     int valid, const Tensor<V>& L, Scalar cell, Scalar time, Scalar dt,
                                                     StepLimits<V>& limits) {
  const auto motion = Tensor<V>::identity() + V(dt) * L;
  const V growth = determinant(motion), old_volume = load<V>(body.volume() + p), new_volume = old_volume * growth;
  Increment<V> step{.L = L, .dt = V(dt), .time = V(time + dt), .size = body.template particle_size<V>(p)};
  step.cell = V(cell);
  step.J_old = body.template relative_volume<V>(p);
  step.J = step.J_old * growth;
  if constexpr (Body::stores_F) {
    step.F = motion * body.template F<V>(p);
    body.store_F(p, step.F);
  }
  auto state = body.template state<V>(p);
  const auto old_stress = body.template stress<V>(p);
  law.update(state, step);
  body.store(p, state);
  if constexpr (Body::Shape::domain_motion != DomainMotion::corners) store(new_volume, body.volume() + p);
  const auto D = symmetric(L);
  const auto mean = V(0.5) * (old_stress + body.template stress<V>(p));
  const V work = V(0.5) * (old_volume + new_volume) * inner(mean, D) * V(dt);

  const auto moduli = law.tangent(state, step.J);
  V specific = new_volume / load<V>(body.mass() + p), viscous(0);
  if constexpr (requires { law.viscosity; }) {
    const V c = sqrt(moduli.longitudinal * specific), rate_of_volume = trace(L);
    viscous =
        V(-dt) * rate_of_volume * new_volume * law.viscosity.pressure(V(1) / specific, c, rate_of_volume, V(cell));
    const V factor = law.viscosity.step_factor(c, rate_of_volume, V(cell));
    specific = specific / (factor * factor);
  }
  const V lambda = max(moduli.longitudinal - V(2) * moduli.shear, V(0)) * specific, shear = moduli.shear * specific;
  const V rate = inner(D, D);
  const auto unsound = !(new_volume > V(0)) || !(V(0) * work <= V(0));
  if constexpr (lane_count < V >> 1) {
    if (valid < lane_count<V>) [[unlikely]] {
      const auto meant = first_lanes<V>(valid);
      const V none(0);
      limits.raise(limits.lambda, select(meant, lambda, none));
      limits.raise(limits.shear, select(meant, shear, none));
      limits.raise(limits.rate, select(meant, rate, none));
      return {select(meant, work, none), select(meant, viscous, none), meant && unsound};
    }
  }
  limits.raise(limits.lambda, lambda);
  limits.raise(limits.shear, shear);
  limits.raise(limits.rate, rate);
  return {work, viscous, unsound};
}

template <class Body>
std::size_t chunk_count(const Body& body) {
  return (body.size() + chunk_size - 1) / chunk_size;
}
/// Work done on particles, J, and the part of it that bulk viscosity took.
struct StrainWork {
  double total = 0, viscous = 0;
  StrainWork& operator+=(const StrainWork& other) {
    total += other.total, viscous += other.viscous;
    return *this;
  }
};
/// Calls f(first, count, bad) for every chunk; it returns the work done and lowers `bad` to a particle whose state is
/// no longer sound. The work is added to the body's in a fixed order. Returns the first bad particle, or body.size().
template <class Body, class F>
std::size_t sum_work(Body& body, const ChunkList& chunks, std::vector<StrainWork>& partial, const F& f) {
  partial.resize(chunks.size());
  const std::int64_t none = std::int64_t(body.size());
  const auto lesser = [](std::int64_t a, std::int64_t b) { return std::min(a, b); };
  const std::int64_t bad = over_parts(
      std::int64_t(chunks.size()), chunks.worth_threads(), none,
      [&](std::int64_t begin, std::int64_t end) {
        std::int64_t bad_here = none;
        for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k)
          partial[k] = f(chunks.first(k), chunks.count(k), bad_here);
        return bad_here;
      },
      lesser);
  StrainWork work;
  for (const auto& w : partial) work += w;
  body.stress_work += work.total;
  body.viscous_work += work.viscous;
  return std::size_t(bad);
}

/// The strain of a chunk of particles, register by register.
template <class V>
struct ChunkStrain {
  using Mask = decltype(V() < V());
  V total_work{0}, viscous_work{0};
  StepLimits<V> limits{.known = true};
  Mask unsound[chunk_size / lane_count<V>], found{};

  /// Takes in the result of the register from entry `l` of the chunk on.
  void add(int l, const StrainResult<V>& result) {
    total_work += result.work;
    viscous_work += result.viscous;
    unsound[l / lane_count<V>] = result.unsound;
    found = found || result.unsound;
  }
  StrainWork work() const { return {double(total(total_work)), double(total(viscous_work))}; }
  /// Lowers `bad` to the first unsound particle of the chunk of `size` particles that begins with `first`.
  void report(std::size_t first, int size, std::int64_t& bad) const {
    if (!any(found)) return;
    for (int l = size - 1; l >= 0; --l)
      if (unsound[l / lane_count<V>].v[l % lane_count<V>]) bad = std::min(bad, std::int64_t(first) + l);
  }
};

/// Strains one particle with the nodal velocities; see update_stress.
template <bool Move, class Body, class Nodes, class Dilatation, class S = typename Body::SpaceType,
          class Scalar = typename S::Scalar>
StrainWork update_stress(Body& body, std::size_t p, const Nodes& nodes, const std::vector<Vector<S>>& velocity,
                         const Dilatation& dilatation, Scalar cell, Scalar time, Scalar dt, std::int64_t& bad,
                         StepLimits<Scalar>& limits) {
  const auto stencil = make_stencil(body, p, nodes);
  const auto L = dilatation(p, velocity_gradient<S>(stencil, velocity, body.x(0)[p]));
  const auto result = strain(body, body.law, p, 1, L, cell, time, dt, limits);
  if (result.unsound) bad = std::min(bad, std::int64_t(p));
  if constexpr (Move) {
    ride<S>(body, p, stencil, nodes, dt, limits);
  }
  return {double(result.work), double(result.viscous)};
}

/// Strains every particle of the chunks with the nodal velocities, moves its volume (and F) along, and calls the law.
///
/// With Move the particle then rides the nodes, x_p += dt sum w_Ip v_I, with the very weights that strained it: those
/// of its new domain may rest on nodes that hold next to nothing.
///
/// In MUSL `velocity` is the remapped field. `dilatation(p, L)` is L, or L with another rate of volume. The work V
/// sigma : D dt is added up in a fixed order. Returns the first particle whose volume or stress is no longer a finite
/// positive number, or body.size(); `limits` gets those of every chunk.
template <bool Move, class Body, class Nodes, class Dilatation, class S = typename Body::SpaceType,
          class Scalar = typename S::Scalar>
std::size_t update_stress(Body& body, const ChunkList& chunks, const Nodes& nodes,
                          const std::vector<Vector<S>>& velocity, const Dilatation& dilatation, Scalar cell,
                          Scalar time, Scalar dt, std::vector<StrainWork>& partial,
                          std::vector<StepLimits<Scalar>>& limits) {
  limits.resize(chunk_count(body));
  return sum_work(body, chunks, partial, [&](std::size_t first, int count, std::int64_t& bad) {
    StrainWork sum;
    StepLimits<Scalar> limit{.known = true};
    for (std::size_t p = first; p < first + std::size_t(count); ++p)
      sum += update_stress<Move>(body, p, nodes, velocity, dilatation, cell, time, dt, bad, limit);
    limits[first / chunk_size] = limit;
    return sum;
  });
}

}  // namespace mpm
