// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/domain_weights.hpp>
#include <mpm/passes/scatter_lanes.hpp>

// Velocities that vary affinely round a particle, on shape functions in modes: the passes of apic.hpp. A node at the
// offset k from the anchor gets sum w m (v + h C (k - c)), c being the centre of the weights as seen from the anchor.
namespace mpm::lanes {

namespace detail {
using namespace mpm::detail;

/// First and second moments of the weights of a register of particles about their anchors, cells, and the farthest node
/// of each axis below and above.
template <class V, int D>
struct WeightMoments {
  V first[D], second[D][D], low[D], high[D];

  V centred(int i, int j) const { return second[i][j] - first[i] * first[j]; }
  /// Largest square of the distance of a node from the centre.
  V farthest() const {
    V sum(0);
    for (int d = 0; d < D; ++d) {
      const V below = low[d] - first[d], above = high[d] - first[d];
      sum += max(below * below, above * above);
    }
    return sum;
  }
};

/// From the weights along axes, of the register that begins at entry l. What lies beyond a face stands for the face's
/// node, or for the linear continuation of the two within.
template <bool continued, class V, class S, int K>
[[gnu::always_inline]] inline void moments_of(const ChunkWeights<S, K>& w, int l, const Grid<S>& grid,
                                              WeightMoments<V, S::dimension>& m) {
  constexpr int stored = ChunkWeights<S, K>::stored, before = shapes::nodes_before<K>;
  for (int d = 0; d < S::dimension; ++d) {
    const auto weight = [&](int k) { return V::load(&w.weight[d][k][l]); };
    V first(0), second(0);
    for (int k = 0; k < stored; ++k) {
      const V at(k - before + (K > 2 && k >= before ? 1 : 0)), part = at * weight(k);
      first += part, second += part * at;
    }
    m.low[d] = V(-before), m.high[d] = V(K - 1 - before);
    if constexpr (K > 2) {
      typename V::Integers anchor;
      std::memcpy(&anchor, &w.anchor[d][l], sizeof(anchor));
      const V place = as_lanes<V>(anchor), one(1), zero(0);
      const V below = select(place < one, one, zero),
              above = select(place > V(grid.cells(d) + before + 1 - K), one, zero);
      const V beyond_low = below * weight(0), beyond_high = above * weight(stored - 1);
      if constexpr (continued) {
        second -= V(2) * (beyond_low + beyond_high);
      } else {
        first += beyond_low - beyond_high;
        second -= beyond_low + beyond_high;
      }
      m.low[d] += below, m.high[d] -= above;
    }
    m.first[d] = first, m.second[d][d] = second;
  }
  for (int i = 0; i < S::dimension; ++i)
    for (int j = 0; j < i; ++j) m.second[i][j] = m.first[i] * m.first[j];
}
/// From the modes of the plane; a domain has no weight beyond a face.
template <bool, class V, class S>
[[gnu::always_inline]] inline void moments_of(const DomainWeights<S>& w, int l, const Grid<S>&,
                                              WeightMoments<V, 2>& m) {
  const auto weight = [&](int k) { return V::load(&w.weight[k][l]); };
  m.first[0] = weight(2) - weight(1), m.second[0][0] = weight(2) + weight(1);
  m.first[1] = weight(6) - weight(3), m.second[1][1] = weight(6) + weight(3);
  m.second[1][0] = (weight(4) + weight(8)) - (weight(5) + weight(7));
  for (int d = 0; d < 2; ++d) m.low[d] = V(-1), m.high[d] = V(1);
}

/// Words with the numbers f(0), f(1), ... f(count - 1) of a register of particles, four in each.
template <int count, class V, class F>
[[gnu::always_inline]] inline void pack(const F& f, int l, Word<typename V::Scalar> (*words)[chunk_size]) {
  for (int k = 0; k < count; k += 4) {
    V at[4];
    for (int i = 0; i < 4; ++i) at[i] = k + i < count ? f(k + i) : V(0);
    to_words(at[0], at[1], at[2], at[3], &words[k / 4][l]);
  }
}

/// Offsets of the nodes of a stencil from its anchor along each axis, those beyond a face at the face.
template <class S, int K>
struct StencilOffsets {
  typename S::Scalar along[S::dimension][K];
  explicit StencilOffsets(const StencilNodes<S, K>& nodes) {
    for (int d = 0; d < S::dimension; ++d) {
      for (int k = 0; k < K; ++k) along[d][k] = typename S::Scalar(k - shapes::nodes_before<K>);
      if (nodes.beyond[d] < 0) along[d][0] += 1;
      if (nodes.beyond[d] > 0) along[d][K - 1] -= 1;
    }
  }
  typename S::Scalar operator()(int node, int d) const { return along[d][node / shapes::power(K, d) % K]; }
};

}  // namespace detail

/// m_I += w m and momentum_I += w m (v + C (x_I - x_c)), x_c = sum w x_I. `find(B, D, farthest, C)` gives C from the
/// columns B, m2/s, row by row, and D = sum w (x_I - x_c)(x_I - x_c)^T; `plainly(p)` does it all for a particle whose
/// weights are not to be had in modes.
template <class Body, class ColumnsT, class Find, class Plain, class S = typename Body::SpaceType>
void scatter_affine(const Body& body, const ParticleOrder& order, const ColumnsT& B, Grid<S>& grid,
                    std::vector<Vector<S>>& momentum, const Find& find, const Plain& plainly) {
  using Scalar = typename S::Scalar;
  using V = typename Body::Lane;
  using Word = detail::Word<Scalar>;
  constexpr int D = S::dimension, K = Body::Shape::axis_nodes, count = shapes::power(K, D);
  constexpr int numbers = D + 1 + D * D, words = (numbers + 3) / 4;  // m a, m, and m h C column by column
  constexpr bool continued = detail::continues_linearly<typename Body::Shape>;
  const V h(grid.cell());
  for_each_strip(order, [&](std::size_t begin, std::size_t end) {
    typename detail::WeightsOf<Body>::Type w;
    Word value[words][chunk_size];
    for (std::size_t first = begin; first < end; first += chunk_size) {
      const int size = int(std::min<std::size_t>(chunk_size, end - first));
      if (!w.compute(body, first, size, grid)) {
        for (std::size_t p = first; p < first + std::size_t(size); ++p) plainly(p);
        continue;
      }
      for (int l = 0; l < size; l += V::size) {
        const std::size_t p = first + std::size_t(l);
        detail::WeightMoments<V, D> moments;
        detail::moments_of<continued>(w, l, grid, moments);
        V own[D][D], spread[D][D], C[D][D], a[D];
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j) {
            own[i][j] = V::load(B[i * D + j] + p);
            if (j <= i) spread[i][j] = h * h * moments.centred(i, j);
          }
        find(own, spread, h * h * moments.farthest(), C);
        for (int i = 0; i < D; ++i) {
          a[i] = V::load(body.v(i) + p);
          for (int j = 0; j < D; ++j) a[i] -= h * C[i][j] * moments.first[j];
        }
        const V m = V::load(body.mass() + p);
        detail::pack<numbers, V>(
            [&](int k) { return k < D    ? m * a[k]
                                : k == D ? m
                                         : m * h * C[(k - D - 1) % D][(k - D - 1) / D]; }, l,
            value);
      }
      for (int p = 0, next; p < size; p = next) {
        next = w.run_end(p, size);
        const detail::StencilNodes<S, K> nodes(grid, w.anchor, p);
        const detail::StencilOffsets<S, K> offset(nodes);
        Word sum[words][count]{};
        for (int word = 0; word < words; ++word) {
          for (int q = p; q < next; ++q) {
            Word mode[count];
            detail::modes_of<D, K>(value[word][q], w, q, mode);
            shapes::unrolled<count>([&](auto I) __attribute__((always_inline)) { sum[word][I] += mode[I]; });
          }
          shapes::all_to_nodes<D, K>(sum[word]);
          if constexpr (continued) nodes.fold_sums(sum[word]);
        }
        nodes.for_each([&](auto I, std::size_t n) __attribute__((always_inline)) {
          const auto number = [&](int k) { return sum[k / 4][I][k % 4]; };
          grid.mass[n] += number(D);
          for (int i = 0; i < D; ++i) {
            Scalar part = number(i);
            for (int j = 0; j < D; ++j) part += offset(I, j) * number(D + 1 + j * D + i);
            momentum[n][i] += part;
          }
        });
      }
    }
    return end;
  });
  for (std::size_t p = order.tail_begin(); p < body.size(); ++p) plainly(p);
}

/// B = sum w v_I (x_I - x_c)^T in columns, row by row; `plainly(p)` for a particle whose weights are not to be had in
/// modes.
template <class Body, class ColumnsT, class Plain, class S = typename Body::SpaceType>
void gather_affine(const Body& body, const ChunkList& chunks, const Grid<S>& grid, ColumnsT& B, const Plain& plainly) {
  using Scalar = typename S::Scalar;
  using V = typename Body::Lane;
  using Word = detail::Word<Scalar>;
  constexpr int D = S::dimension, K = Body::Shape::axis_nodes, count = shapes::power(K, D);
  constexpr int numbers = D + D * D, words = (numbers + 3) / 4;  // v, and v k column by column
  constexpr bool continued = detail::continues_linearly<typename Body::Shape>;
  const V h(grid.cell());
  chunks.for_each([&](std::size_t first, int size) {
    typename detail::WeightsOf<Body>::Type w;
    if (!w.compute(body, first, size, grid)) {
      for (std::size_t p = first; p < first + std::size_t(size); ++p) plainly(p);
      return;
    }
    Word seen[words][chunk_size];
    for (int p = 0, next; p < size; p = next) {
      next = w.run_end(p, size);
      const detail::StencilNodes<S, K> nodes(grid, w.anchor, p);
      const detail::StencilOffsets<S, K> offset(nodes);
      for (int word = 0; word < words; ++word) {
        Word mode[count];
        nodes.for_each([&](auto I, std::size_t n) __attribute__((always_inline)) {
          mode[I] = Word{};
          for (int s = 0; s < std::min(4, numbers - 4 * word); ++s) {
            const int k = 4 * word + s, j = (k - D) / D;
            mode[I][s] = k < D ? grid.velocity[n][k] : offset(I, j) * grid.velocity[n][(k - D) % D];
          }
        });
        if constexpr (continued) nodes.continue_field(mode);
        shapes::all_to_modes<D, K>(mode);
        for (int q = p; q < next; ++q) detail::value_of<D, K>(mode, w, q, seen[word][q]);
      }
    }
    for (int l = 0; l < size; l += V::size) {
      detail::WeightMoments<V, D> moments;
      detail::moments_of<continued>(w, l, grid, moments);
      std::array<V, 4> number[words];
      for (int word = 0; word < words; ++word) number[word] = detail::to_lanes<V>(&seen[word][l]);
      const auto at = [&](int k) { return number[k / 4][std::size_t(k % 4)]; };
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          store(h * (at(D + j * D + i) - at(i) * moments.first[j]), B[i * D + j] + first + std::size_t(l));
    }
  });
}

}  // namespace mpm::lanes
