// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/domain_weights.hpp>
#include <mpm/passes/update_stress.hpp>

// The passes of gather.hpp and update_stress.hpp for shape functions in modes, in one.
namespace mpm::lanes {

namespace detail {
using namespace mpm::detail;

/// Two nodal vectors: in one word, in space in one each.
template <class S>
struct GatherRecord {
  static constexpr int D = S::dimension;
  static constexpr int words = D == 3 ? 2 : 1;
  using W = Word<typename S::Scalar>;

  /// Word of the field `f` (0 or 1), and the slot it starts at.
  static constexpr int word(int f) { return D == 3 ? f : 0; }
  static constexpr int slot(int f) { return D == 3 ? 0 : f * D; }
  [[gnu::always_inline]] static void read(int word, const std::vector<Vector<S>>& a, const std::vector<Vector<S>>& b,
                                          std::size_t node, W& to) {
    if constexpr (D == 1) {
      to = W{a[node][0], b[node][0]};
    } else if constexpr (D == 2) {
      join(a[node].data(), b[node].data(), to);
    } else {
      const auto& v = word == 0 ? a[node] : b[node];
      to = W{v[0], v[1], v[2]};
    }
  }
};

/// New velocities and positions of a register of particles, of which `valid` are meant, where asked for.
template <bool Blend, bool Move, class Body, class Integrator, class V, class Scalar = typename Body::Scalar>
[[gnu::always_inline]] inline void move_register(Body& body, std::size_t p, int valid, int d, const V& velocity,
                                                 const V& increment, const Integrator& integrator, Scalar dt,
                                                 StepLimits<V>& limits) {
  if constexpr (Blend) store(integrator.particle_velocity(V::load(body.v(d) + p), velocity, increment), body.v(d) + p);
  if constexpr (Move) {
    store(V::load(body.x(d) + p) + V(dt) * velocity, body.x(d) + p);
    const V speed = abs(velocity);
    limits.raise(limits.speed, valid >= V::size ? speed : select(first_lanes<V>(valid), speed, V(0)));
  }
}

/// Values, and slopes of one of them, of two nodal fields at a chunk of particles.
template <class S, Strained strained, bool continued>
struct Seen {
  using Record = GatherRecord<S>;
  using Scalar = typename S::Scalar;
  static constexpr int D = S::dimension;
  static constexpr int field = strained == Strained::by_second;
  typename Record::W values[Record::words][chunk_size], slopes[D][chunk_size];

  template <bool Both, int K, class Weights>
  [[gnu::always_inline]] void compute(const Weights& w, int size, const Grid<S>& grid,
                                      const std::vector<Vector<S>>& first, const std::vector<Vector<S>>& second) {
    using Word = typename Record::W;
    constexpr int count = shapes::power(K, D);
    for (int p = 0, next; p < size; p = next) {
      next = w.run_end(p, size);
      const StencilNodes<S, K> nodes(grid, w.anchor, p);
      shapes::unrolled<Record::words>([&](auto word) __attribute__((always_inline)) {
        constexpr bool with_slopes = strained != Strained::none && word == Record::word(field);
        if constexpr (with_slopes || Both || word == 0) {
          Word mode[count];
          nodes.for_each([&](auto I, std::size_t node)
                             __attribute__((always_inline)) { Record::read(word, first, second, node, mode[I]); });
          if constexpr (continued) nodes.continue_field(mode);
          shapes::all_to_modes<D, K>(mode);
          for (int q = p; q < next; ++q) {
            if constexpr (with_slopes) {
              Word slope[D];
              value_of<D, K>(mode, w, q, values[word][q], slope);
              for (int d = 0; d < D; ++d) slopes[d][q] = slope[d];
            } else {
              value_of<D, K>(mode, w, q, values[word][q]);
            }
          }
        }
      });
    }
  }
  /// Velocity gradient of a register from `l` on, lifted to 3x3.
  template <class V>
  [[gnu::always_inline]] Tensor<V> gradient(int l, Scalar inverse_cell, const V& radius,
                                            const std::array<V, 4>* value) const {
    std::array<V, 4> grad[D];
    for (int d = 0; d < D; ++d) grad[d] = to_lanes<V>(&slopes[d][l]);
    const auto slope = [&](int i, int j) { return grad[j][std::size_t(Record::slot(field) + i)] * V(inverse_cell); };
    Tensor<V> L;
    L.xx = slope(0, 0);
    if constexpr (D > 1) L.xy = slope(0, 1), L.yx = slope(1, 0), L.yy = slope(1, 1);
    if constexpr (D > 2)
      L.xz = slope(0, 2), L.yz = slope(1, 2), L.zx = slope(2, 0), L.zy = slope(2, 1), L.zz = slope(2, 2);
    if constexpr (S::hoop) L.zz = value[Record::word(field)][std::size_t(Record::slot(field))] / radius;
    return L;
  }
};

}  // namespace detail

/// A particle's way back from the nodes: new velocity from the first field and the increment, the second (`Blend`),
/// strain and stress, and position (`Move`). Returns the first particle whose volume or stress is no longer a finite
/// positive number, or body.size(); `limits` gets those of every chunk.
template <bool Blend, Strained strained, bool Move, class Body, class Integrator, class S = typename Body::SpaceType>
std::size_t update(Body& body, const ChunkList& chunks, const Grid<S>& grid, const std::vector<Vector<S>>& first_field,
                   const std::vector<Vector<S>>& second_field, const Integrator& integrator, typename S::Scalar time,
                   typename S::Scalar dt, std::vector<StrainWork>& partial,
                   std::vector<StepLimits<typename S::Scalar>>& limits) {
  using V = typename Body::Lane;
  using Record = detail::GatherRecord<S>;
  constexpr int D = S::dimension, K = Body::Shape::axis_nodes;
  limits.resize(chunk_count(body));
  return sum_work(body, chunks, partial, [&](std::size_t first, int size, std::int64_t& bad) {
    LoopLaw<Body> law = body.law;
    typename detail::WeightsOf<Body>::Type w;
    StepLimits<typename S::Scalar> limit{.known = true};
    StrainWork work;
    if (!w.compute(body, first, size, grid)) {
      for (std::size_t p = first; p < first + std::size_t(size); ++p) {
        if constexpr (Blend) gather_velocity(body, p, grid, integrator);
        if constexpr (strained == Strained::none) {
          static_assert(!Move || Blend);
          if constexpr (Move) ride<S>(body, p, make_stencil(body, p, grid), grid, dt, limit);
        } else {
          work += update_stress<Move>(body, p, grid, strained == Strained::by_first ? first_field : second_field,
                                      OwnDilatation{}, grid.cell(), time, dt, bad, limit);
        }
      }
    } else {
      detail::Seen<S, strained, detail::continues_linearly<typename Body::Shape>> seen;
      seen.template compute<Blend, K>(w, size, grid, first_field, second_field);
      ChunkStrain<V> strained_chunk;
      for (int l = 0; l < size; l += V::size) {
        const std::size_t p = first + std::size_t(l);
        std::array<V, 4> value[Record::words];
        for (int k = 0; k < Record::words; ++k) value[k] = detail::to_lanes<V>(&seen.values[k][l]);
        if constexpr (strained != Strained::none) {
          const auto L = seen.template gradient<V>(l, grid.inverse_cell(), V::load(body.x(0) + p), value);
          strained_chunk.add(l, mpm::strain(body, law, p, size - l, L, grid.cell(), time, dt, strained_chunk.limits));
        }
        for (int d = 0; d < D; ++d)
          detail::move_register<Blend, Move>(
              body, p, size - l, d, value[Record::word(0)][std::size_t(Record::slot(0) + d)],
              value[Record::word(1)][std::size_t(Record::slot(1) + d)], integrator, dt, strained_chunk.limits);
      }
      if constexpr (strained != Strained::none) strained_chunk.report(first, size, bad);
      work = strained_chunk.work();
      limit = over_lanes(strained_chunk.limits);
    }
    if constexpr (strained != Strained::none) {
      limits[first / chunk_size] = limit;
    } else if constexpr (Move) {
      limits[first / chunk_size].speed = limit.speed;
    }
    return work;
  });
}

}  // namespace mpm::lanes
