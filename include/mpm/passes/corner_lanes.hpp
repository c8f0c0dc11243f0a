// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/corner_nodes.hpp>
#include <mpm/passes/gather_lanes.hpp>
#include <mpm/passes/scatter_lanes.hpp>

// Between particles and their own corners, a chunk at a time: what scatter.hpp, gather.hpp and update_stress.hpp do
// with the corner stencil.
namespace mpm::lanes {

namespace detail {
using namespace mpm::detail;

/// The quadrilaterals of a chunk of particles: area, weights of the corners, and the gradients of the first two; those
/// of the opposite corners are their negatives. See CpdiQuad::weights.
template <class V>
struct QuadWeights {
  V area, weight[4], gradient[2][2];

  template <class Shape>
  [[gnu::always_inline]] QuadWeights(const Shape& shape, std::size_t first, int size) {
    alignas(64) double at[2][4][V::size];
    for (int k = 0; k < V::size; ++k) {
      const auto& quad = shape.quad[first + std::size_t(std::min(k, size - 1))];
      for (int c = 0; c < 4; ++c)
        for (int d = 0; d < 2; ++d) at[d][c][k] = shape.corner[quad[std::size_t(c)]][std::size_t(d)];
    }
    V x[4], y[4];
    for (int c = 0; c < 4; ++c) x[c] = V::load(at[0][c]), y[c] = V::load(at[1][c]);
    area = V(0.5) * ((x[2] - x[0]) * (y[3] - y[1]) - (x[3] - x[1]) * (y[2] - y[0]));
    const V a = (x[3] - x[0]) * (y[1] - y[2]) - (x[1] - x[2]) * (y[3] - y[0]);
    const V b = (x[2] - x[3]) * (y[0] - y[1]) - (x[0] - x[1]) * (y[2] - y[3]);
    const V inverse = V(1) / area, s = V(1.0 / 24) * inverse, g = V(0.5) * inverse, six = V(6) * area;
    weight[0] = (six - a - b) * s, weight[1] = (six - a + b) * s;
    weight[2] = (six + a + b) * s, weight[3] = (six + a - b) * s;
    gradient[0][0] = (y[1] - y[3]) * g, gradient[0][1] = (x[3] - x[1]) * g;
    gradient[1][0] = (y[2] - y[0]) * g, gradient[1][1] = (x[0] - x[2]) * g;
  }
};

}  // namespace detail

/// m_c += w m and (m v)_c += w m v, f_c += -V sigma grad w + w m b, or both at once.
template <What what, class Body, class Force, class S = typename Body::SpaceType>
std::size_t scatter(const Body& body, const ParticleOrder& order, CornerNodes<S>& corners,
                    std::vector<Vector<S>>& momentum, const Force& body_force, double time) {
  using V = typename Body::Lane;
  using Word = detail::Word<double>;
  constexpr bool force = gives_forces<what>, mass = gives_mass<what>, velocity = gives_momentum<what>;

  return for_each_strip(order, [&](std::size_t begin, std::size_t end) {
    std::size_t bad = std::numeric_limits<std::size_t>::max();
    for (std::size_t first = begin; first < end; first += V::size) {
      const int size = int(std::min<std::size_t>(V::size, end - first));
      const detail::QuadWeights<V> w(body.shape, first, size);
      const V m = V::load(body.mass() + first), zero(0);
      Word value[V::size], flux[2][V::size], weight[V::size];
      V push[2][2]{}, b[2]{};
      if constexpr (force) {
        bad = std::min(bad, first_unsound<V>(body, first, size));
        const auto s = body.template stress<V>(first);
        const V volume = -V::load(body.volume() + first);
        for (int c = 0; c < 2; ++c) {
          push[c][0] = volume * (s.xx * w.gradient[c][0] + s.xy * w.gradient[c][1]);
          push[c][1] = volume * (s.xy * w.gradient[c][0] + s.yy * w.gradient[c][1]);
        }
        detail::weight_of(body, first, size, m, body_force, time, b);
      }
      detail::to_words(velocity ? m * V::load(body.v(0) + first) : zero,
                       velocity ? m * V::load(body.v(1) + first) : zero, b[0], b[1], value);
      for (int c = 0; c < 2; ++c) detail::to_words(zero, zero, push[c][0], push[c][1], flux[c]);
      detail::to_words(w.weight[0], w.weight[1], w.weight[2], w.weight[3], weight);
      for (int k = 0; k < size; ++k) {
        const auto& quad = body.shape.quad[first + std::size_t(k)];
        const double mk = body.mass()[first + std::size_t(k)];
        shapes::unrolled<4>([&](auto c) __attribute__((always_inline)) {
          const Word part = weight[k][int(c)] * value[k] + (c < 2 ? flux[c % 2][k] : -flux[c % 2][k]);
          const std::size_t corner = quad[c];
          if constexpr (mass) corners.mass[corner] += weight[k][int(c)] * mk;
          if constexpr (velocity) detail::add_pair<0>(part, momentum[corner].data());
          if constexpr (force) detail::add_pair<2>(part, corners.increment[corner].data());
        });
      }
    }
    return bad;
  });
}

/// The twin of lanes::update for particles that see their own corners. Positions and volumes follow in
/// CpdiQuad::convect.
template <bool Blend, Strained strained, class Body, class Integrator, class S = typename Body::SpaceType>
std::size_t update(Body& body, const ChunkList& chunks, const std::vector<Vector<S>>& first_field,
                   const std::vector<Vector<S>>& second_field, double cell, const Integrator& integrator, double time,
                   double dt, std::vector<double>& partial, std::vector<StepLimits<double>>& limits) {
  using V = typename Body::Lane;
  using Word = detail::Word<double>;
  constexpr std::size_t from = strained == Strained::by_second ? 2 : 0;
  limits.resize(chunk_count(body));
  LoopLaw<Body> law = body.law;
  return sum_work(body, chunks, partial, [&](std::size_t chunk, int count, std::int64_t& bad) {
    ChunkStrain<V> strained_chunk;
    Word fastest{};  // corner
    for (int l = 0; l < count; l += V::size) {
      const std::size_t p = chunk + std::size_t(l);
      const int size = std::min(V::size, count - l);
      const detail::QuadWeights<V> w(body.shape, p, size);
      Word first_pair[V::size], second_pair[V::size], sum[V::size], weight[V::size];
      detail::to_words(w.weight[0], w.weight[1], w.weight[2], w.weight[3], weight);
      for (int k = 0; k < V::size; ++k) {
        const auto& quad = body.shape.quad[p + std::size_t(std::min(k, size - 1))];
        Word at[4];
        for (std::size_t c = 0; c < 4; ++c) {
          detail::join(first_field[quad[c]], second_field[quad[c]], at[c]);
          const Word speed = at[c] < 0 ? -at[c] : at[c];
          fastest = speed > fastest ? speed : fastest;
        }
        sum[k] = weight[k][0] * at[0] + weight[k][1] * at[1] + (weight[k][2] * at[2] + weight[k][3] * at[3]);
        first_pair[k] = at[0] - at[2], second_pair[k] = at[1] - at[3];
      }
      if constexpr (strained != Strained::none) {
        const auto a = detail::to_lanes<V>(first_pair), b = detail::to_lanes<V>(second_pair);
        Tensor<V> L;
        L.xx = a[from] * w.gradient[0][0] + b[from] * w.gradient[1][0];
        L.xy = a[from] * w.gradient[0][1] + b[from] * w.gradient[1][1];
        L.yx = a[from + 1] * w.gradient[0][0] + b[from + 1] * w.gradient[1][0];
        L.yy = a[from + 1] * w.gradient[0][1] + b[from + 1] * w.gradient[1][1];
        strained_chunk.add(l, mpm::strain(body, law, p, size, L, cell, time, dt, strained_chunk.limits));
      }
      if constexpr (Blend) {
        const auto seen = detail::to_lanes<V>(sum);
        for (int d = 0; d < 2; ++d)
          detail::move_register<true, false>(body, p, size, d, seen[std::size_t(d)], seen[std::size_t(d) + 2],
                                             integrator, dt, strained_chunk.limits);
      }
    }
    if constexpr (strained != Strained::none) strained_chunk.report(chunk, count, bad);
    StepLimits<double> limit = over_lanes(strained_chunk.limits);
    limit.speed = std::max(fastest[from], fastest[from + 1]);
    if constexpr (strained != Strained::none) {
      limits[chunk / chunk_size] = limit;
    } else {
      limits[chunk / chunk_size].speed = limit.speed;
    }
    return double(total(strained_chunk.work));
  });
}

}  // namespace mpm::lanes
