// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/corner_nodes.hpp>
#include <mpm/passes/gather_lanes.hpp>
#include <mpm/passes/quad_weights.hpp>
#include <mpm/passes/scatter_lanes.hpp>

// Between particles and their own corners, a chunk at a time: what scatter.hpp, gather.hpp and update_stress.hpp do
// with the corner stencil.
namespace mpm::lanes {

namespace detail {
using namespace mpm::detail;

/// Adds what quadrilaterals give to their corners. The sums at the edge that a quadrilateral shares with the next one
/// along the mesh stay in registers.
template <class S, bool with_mass>
class EdgeSums {
 public:
  using Scalar = typename S::Scalar;

  explicit EdgeSums(CornerNodes<S>& corners) : corners_(corners) {}
  EdgeSums(const EdgeSums&) = delete;
  ~EdgeSums() {
    if (open_) close();
  }
  /// `part` and `mass` by corner: 0 and 3 on the edge behind, 1 and 2 on the one ahead.
  [[gnu::always_inline]] void add(const std::array<std::uint32_t, 4>& quad, const Word<Scalar>* part,
                                  const Word<Scalar>& mass) {
    Word<Scalar> behind[2] = {part[0], part[3]};
    Scalar mass_behind[2] = {mass[0], mass[3]};
    if (open_ && quad[0] == ahead_[0] && quad[3] == ahead_[1]) {
      for (int e = 0; e < 2; ++e) behind[e] += sum_[e], mass_behind[e] += mass_[e];
    } else if (open_) {
      close();
    }
    give(quad[0], behind[0], mass_behind[0]);
    give(quad[3], behind[1], mass_behind[1]);
    ahead_[0] = quad[1], ahead_[1] = quad[2];
    sum_[0] = part[1], sum_[1] = part[2];
    mass_[0] = mass[1], mass_[1] = mass[2];
    open_ = true;
  }

 private:
  [[gnu::always_inline]] void give(std::size_t corner, const Word<Scalar>& part, Scalar mass) {
    Word<Scalar> sum;
    auto& own = corners_.pair[corner].value;
    std::memcpy(&sum, own.data(), sizeof(sum));
    sum += part;
    std::memcpy(own.data(), &sum, sizeof(sum));
    if constexpr (with_mass) corners_.mass[corner] += mass;
  }
  [[gnu::always_inline]] void close() {
    for (int e = 0; e < 2; ++e) give(ahead_[e], sum_[e], mass_[e]);
  }

  CornerNodes<S>& corners_;
  std::size_t ahead_[2]{};
  Word<Scalar> sum_[2]{};
  Scalar mass_[2]{};
  bool open_ = false;
};

}  // namespace detail

/// m_c += w m and (m v)_c += w m v, f_c += -V sigma grad w + w m b, or both at once, in corners.mass and corners.pair.
template <What what, class Body, class Force, class S = typename Body::SpaceType>
std::size_t scatter(const Body& body, const ParticleOrder& order, CornerNodes<S>& corners, const Force& body_force,
                    double time) {
  using V = typename Body::Lane;
  using Scalar = typename S::Scalar;
  using Word = detail::Word<Scalar>;
  constexpr bool force = gives_forces<what>, velocity = gives_momentum<what>;

  const auto give = [&](std::size_t begin, std::size_t end) {
    std::size_t bad = std::numeric_limits<std::size_t>::max();
    detail::EdgeSums<S, gives_mass<what>> sums(corners);
    for (std::size_t first = begin; first < end; first += V::size) {
      const int size = int(std::min<std::size_t>(V::size, end - first));
      const detail::QuadWeights<V> w(body.shape, first, size);
      const V m = V::load(body.mass() + first), zero(0);
      Word value[V::size], flux[V::size], weight[V::size];
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
      detail::to_words(push[0][0], push[0][1], push[1][0], push[1][1], flux);
      detail::to_words(w.weight[0], w.weight[1], w.weight[2], w.weight[3], weight);
      for (int k = 0; k < size; ++k) {
        const Word none{}, low = __builtin_shufflevector(none, flux[k], 0, 1, 4, 5),
                           high = __builtin_shufflevector(none, flux[k], 0, 1, 6, 7);
        const Word part[4] = {weight[k][0] * value[k] + low, weight[k][1] * value[k] + high,
                              weight[k][2] * value[k] - low, weight[k][3] * value[k] - high};
        sums.add(body.shape.quad[first + std::size_t(k)], part, weight[k] * body.mass()[first + std::size_t(k)]);
      }
    }
    return bad;
  };
  return std::min(for_each_strip(order, give), give(order.tail_begin(), body.size()));
}

/// In the first half of corners.pair the sums w_c m_p sum_d w_d v_d of the corners' velocities; see
/// mpm::scatter_interpolated.
template <class Body, class S = typename Body::SpaceType>
void scatter_interpolated(const Body& body, const ParticleOrder& order, CornerNodes<S>& corners) {
  using V = typename Body::Lane;
  using Scalar = typename S::Scalar;
  using Word = detail::Word<Scalar>;
  corners.for_each([&](std::size_t c) { corners.pair[c] = {}; });
  const auto give = [&](std::size_t begin, std::size_t end) {
    detail::EdgeSums<S, false> sums(corners);
    for (std::size_t first = begin; first < end; first += V::size) {
      const int size = int(std::min<std::size_t>(V::size, end - first));
      const detail::QuadWeights<V> w(body.shape, first, size);
      Word weight[V::size];
      detail::to_words(w.weight[0], w.weight[1], w.weight[2], w.weight[3], weight);
      for (int k = 0; k < size; ++k) {
        const auto& quad = body.shape.quad[first + std::size_t(k)];
        Word seen{}, part[4];
        for (int c = 0; c < 4; ++c) {
          Word at;
          detail::join(corners.velocity[quad[std::size_t(c)]].data(), corners.velocity[quad[std::size_t(c)]].data(),
                       at);
          seen += weight[k][c] * at;
        }
        seen *= body.mass()[first + std::size_t(k)];
        for (int c = 0; c < 4; ++c) part[c] = weight[k][c] * seen;
        sums.add(quad, part, Word{});
      }
    }
    return end;
  };
  for_each_strip(order, give);
  give(order.tail_begin(), body.size());
}

/// What the corners have got, mass and the two halves of corners.pair, where asked for, goes on to the grid:
/// CornerNodes::scatter with the corners of one cell added up before its nodes are touched.
template <bool mass, bool first, bool second, class S, class Masses>
void scatter_corners(const CornerNodes<S>& corners, Masses& node_mass, std::vector<Vector<S>>& first_field,
                     std::vector<Vector<S>>& second_field) {
  using Scalar = typename S::Scalar;
  using Word = detail::Word<Scalar>;
  corners.for_each_strip([&](std::span<const std::uint32_t> list) {
    for (std::size_t k = 0; k < list.size();) {
      const int cell = corners.anchor(list[k]).node;
      Word sum[4]{}, masses{};
      for (; k < list.size() && corners.anchor(list[k]).node == cell; ++k) {
        const std::size_t c = list[k];
        const Scalar x = corners.anchor(c).x, y = corners.anchor(c).y;
        const Word w = Word{1 - x, x, 1 - x, x} * Word{1 - y, 1 - y, y, y};
        Word value;
        std::memcpy(&value, corners.pair[c].value.data(), sizeof(value));
        shapes::unrolled<4>([&](auto n) __attribute__((always_inline)) { sum[n] += w[int(n)] * value; });
        if constexpr (mass) masses += w * corners.mass[c];
      }
      shapes::unrolled<4>([&](auto n) __attribute__((always_inline)) {
        const auto node = std::size_t(cell + n % 2 + n / 2 * corners.stride());
        if constexpr (mass) node_mass[node] += masses[int(n)];
        if constexpr (first) detail::add_pair<0>(sum[n], first_field[node].data());
        if constexpr (second) detail::add_pair<2>(sum[n], second_field[node].data());
      });
    }
  });
}

/// Interpolates two nodal fields of the grid to corners.pair; see CornerNodes::gather.
template <class S>
void gather_corners(CornerNodes<S>& corners, const std::vector<Vector<S>>& first,
                    const std::vector<Vector<S>>& second) {
  using Scalar = typename S::Scalar;
  using Word = detail::Word<Scalar>;
  corners.for_each([&](std::size_t c) {
    const auto& anchor = corners.anchor(c);
    const Scalar x = anchor.x, y = anchor.y;
    const Scalar w[4] = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
    Word value{};
    shapes::unrolled<4>([&](auto n) __attribute__((always_inline)) {
      const auto node = std::size_t(anchor.node + n % 2 + n / 2 * corners.stride());
      Word at;
      detail::join(first[node].data(), second[node].data(), at);
      value += w[n] * at;
    });
    std::memcpy(corners.pair[c].value.data(), &value, sizeof(value));
  });
}

/// The twin of CpdiQuad::convect for the corners: they ride the first or second of the fields gathered last.
template <Strained strained, class Shape, class S>
void move_corners(Shape& shape, const CornerNodes<S>& corners, typename S::Scalar dt) {
  constexpr std::size_t from = strained == Strained::by_second ? 2 : 0;
  corners.for_each([&](std::size_t c) {
    for (std::size_t d = 0; d < 2; ++d) shape.corner[c][d] += double(dt * corners.pair[c].value[from + d]);
  });
}

/// The twin of CpdiQuad::convect for the particles: positions and volumes from their corners. Returns the first whose
/// quadrilateral has lost its area, or whose centroid is not between its corners, or body.size().
template <class Body>
std::size_t follow_corners(Body& body, const ChunkList& particles) {
  using V = typename Body::Lane;
  return particles.least(particles.entries(), [&](std::size_t chunk, int count) {
    std::size_t bad = body.size();
    for (int l = 0; l < count; l += V::size) {
      const std::size_t p = chunk + std::size_t(l);
      const int size = std::min(V::size, count - l);
      const detail::QuadWeights<V> w(body.shape, p, size);
      auto sound = w.area > V(0);
      const auto centroid = [&](const V* x) {
        const V at = w.weight[0] * x[0] + w.weight[1] * x[1] + (w.weight[2] * x[2] + w.weight[3] * x[3]);
        sound = sound && at >= min(min(x[0], x[1]), min(x[2], x[3])) && at <= max(max(x[0], x[1]), max(x[2], x[3]));
        return at;
      };
      const V x = w.origin[0] + centroid(w.x), y = w.origin[1] + centroid(w.y);
      if (any(!sound)) [[unlikely]]
        for (int k = 0; k < size; ++k)
          if (!sound.v[k]) bad = std::min(bad, p + std::size_t(k));
      x.store(body.x(0) + p), y.store(body.x(1) + p), w.area.store(body.volume() + p);
    }
    return bad;
  });
}

/// The twin of lanes::update for particles that see their own corners, with the two fields in corners.pair. Positions
/// and volumes follow their corners later.
template <bool Blend, Strained strained, class Body, class Integrator, class S = typename Body::SpaceType>
std::size_t update(Body& body, const ChunkList& chunks, const CornerNodes<S>& corners, typename S::Scalar cell,
                   const Integrator& integrator, typename S::Scalar time, typename S::Scalar dt,
                   std::vector<StrainWork>& partial, std::vector<StepLimits<typename S::Scalar>>& limits) {
  using V = typename Body::Lane;
  using Scalar = typename S::Scalar;
  using Word = detail::Word<Scalar>;
  constexpr std::size_t from = strained == Strained::by_second ? 2 : 0;
  limits.resize(chunk_count(body));
  return sum_work(body, chunks, partial, [&](std::size_t chunk, int count, std::int64_t& bad) {
    LoopLaw<Body> law = body.law;
    ChunkStrain<V> strained_chunk;
    Word fastest{};  // corner
    for (int l = 0; l < count; l += V::size) {
      const std::size_t p = chunk + std::size_t(l);
      const int size = std::min(V::size, count - l);
      const detail::QuadWeights<V> w(body.shape, p, size);
      Word first_pair[V::size], second_pair[V::size], sum[V::size], weight[V::size];
      detail::to_words(w.weight[0], w.weight[1], w.weight[2], w.weight[3], weight);
      shapes::unrolled<V::size>([&](auto k) __attribute__((always_inline)) {
        const auto& quad = body.shape.quad[p + std::size_t(std::min(int(k), size - 1))];
        Word at[4];
        shapes::unrolled<4>([&](auto c) __attribute__((always_inline)) {
          std::memcpy(&at[c], corners.pair[quad[c]].value.data(), sizeof(Word));
          Word speed;
          detail::magnitude<Scalar>(at[c], speed);
          fastest = speed > fastest ? speed : fastest;
        });
        sum[k] = weight[k][0] * at[0] + weight[k][1] * at[1] + (weight[k][2] * at[2] + weight[k][3] * at[3]);
        first_pair[k] = at[0] - at[2], second_pair[k] = at[1] - at[3];
      });
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
    StepLimits<Scalar> limit = over_lanes(strained_chunk.limits);
    limit.speed = std::max(fastest[from], fastest[from + 1]);
    if constexpr (strained != Strained::none) {
      limits[chunk / chunk_size] = limit;
    } else {
      limits[chunk / chunk_size].speed = limit.speed;
    }
    return strained_chunk.work();
  });
}

}  // namespace mpm::lanes
