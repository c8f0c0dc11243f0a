// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/locate.hpp>
#include <mpm/passes/words.hpp>
#include <mpm/shapes/modes.hpp>

namespace mpm {

/// A shape function that has its weights in modes.
template <class Body>
concept HasModes =
    requires(const Body b, const Grid<typename Body::SpaceType> g, std::array<typename Body::Lane, Body::dimension> xi,
             std::array<AxisModes<typename Body::Lane, Body::Shape::axis_nodes>, Body::dimension> modes) {
  b.shape.modes(b, std::size_t{}, g, xi, modes);
};

namespace detail {

/// Splines go on linearly beyond a face.
template <class Shape>
inline constexpr bool continues_linearly = requires {
  requires Shape::continues_linearly;
};

/// Coordinates, in cells, of a register of particles; whole numbers can be made of them whatever stands in the room
/// behind the last particle.
template <class Body, class S, class V = typename Body::Lane>
[[gnu::always_inline]] inline std::array<V, S::dimension> coordinates(const Body& body, std::size_t p,
                                                                      const Grid<S>& grid) {
  using Scalar = typename S::Scalar;
  std::array<V, S::dimension> xi;
  for (int d = 0; d < S::dimension; ++d)
    xi[std::size_t(d)] = max(
        V(0), min((V::load(body.x(d) + p) - V(grid.origin()[d])) * V(grid.inverse_cell()), V(Scalar(grid.cells(d)))));
  return xi;
}

/// Where the stencils of a chunk of particles stand.
template <class S>
struct ChunkAnchors {
  alignas(64) std::int32_t anchor[S::dimension][chunk_size];
  alignas(64) std::int32_t node[chunk_size];  ///< anchor, linear

  /// End of the run of particles from p on that share a stencil.
  int run_end(int p, int size) const {
    int q = p + 1;
    while (q < size && node[q] == node[p]) ++q;
    return q;
  }
  template <class Integers>
  [[gnu::always_inline]] void store(int l, int d, const Integers& at, const Grid<S>& grid, Integers& linear) {
    std::memcpy(&anchor[d][l], &at, sizeof(at));
    linear += at * grid.stride(d);
    if (d == S::dimension - 1) std::memcpy(&node[l], &linear, sizeof(linear));
  }
};

/// The weights of a chunk of particles, by axis.
template <class S, int K>
struct ChunkWeights : ChunkAnchors<S> {
  using Scalar = typename S::Scalar;
  static constexpr int D = S::dimension, first = K == 2 ? 0 : 1;  ///< first mode with a weight of its own
  static constexpr int stored = AxisModes<LanesOf<Scalar>, K>::stored;
  static constexpr int mass_words = 1;
  alignas(64) Scalar weight[D][stored][chunk_size];
  alignas(64) Scalar slope[D][stored][chunk_size];

  /// Returns whether modes serve all of the `size` particles.
  template <class Body>
  [[gnu::always_inline]] bool compute(const Body& body, std::size_t begin, int size, const Grid<S>& grid) {
    using V = typename Body::Lane;
    bool fit = true;
    for (int l = 0; l < size; l += V::size) {
      const std::size_t p = begin + std::size_t(l);
      std::array<AxisModes<V, K>, D> modes;
      fit = body.shape.modes(body, p, grid, coordinates(body, p, grid), modes) && fit;
      typename V::Integers linear{};
      for (int d = 0; d < D; ++d) {
        const auto& m = modes[std::size_t(d)];
        for (int k = 0; k < stored; ++k) m.weight[std::size_t(k)].store(&weight[d][k][l]);
        for (int k = 0; k < stored; ++k) m.slope[std::size_t(k)].store(&slope[d][k][l]);
        this->store(l, d, m.anchor, grid, linear);
      }
    }
    return fit;
  }
  /// Those of the register of particles from l on.
  template <class V>
  [[gnu::always_inline]] void read(int l, std::array<AxisModes<V, K>, D>& modes) const {
    for (int d = 0; d < D; ++d) {
      auto& m = modes[std::size_t(d)];
      for (int k = 0; k < stored; ++k) m.weight[std::size_t(k)] = V::load(&weight[d][k][l]);
      for (int k = 0; k < stored; ++k) m.slope[std::size_t(k)] = V::load(&slope[d][k][l]);
      std::memcpy(&m.anchor, &this->anchor[d][l], sizeof(m.anchor));
    }
  }
  /// The masses m of a register of particles by the modes of the first axis, and, from these, their sums by mode of the
  /// plane, a word a row.
  template <class V>
  [[gnu::always_inline]] void weigh(int l, const V& m, Word<Scalar> (*words)[chunk_size]) const {
    V by_mode[4]{m};
    for (int k = 0; k < stored; ++k) by_mode[k + first] = m * V::load(&weight[0][k][l]);
    to_words(by_mode[0], by_mode[1], by_mode[2], by_mode[3], &words[0][l]);
  }
  [[gnu::always_inline]] void add_mass(const Word<Scalar> (*words)[chunk_size], int p, Word<Scalar>* rows) const {
    if (first == 1) rows[0] += words[0][p];
    for (int k = 0; k < stored; ++k) rows[k + first] += weight[1][k][p] * words[0][p];
  }
};

/// The nodes of the stencil about an anchor; those beyond a face are folded onto it, or stand for the linear
/// continuation of the two within.
template <class S, int K>
struct StencilNodes {
  static constexpr int D = S::dimension, rows = shapes::power(K, D - 1);
  std::ptrdiff_t row[rows];  ///< first node of each, beyond a face or not
  std::ptrdiff_t in_row[K];  ///< along the first axis
  int beyond[D];             ///< -1 or 1 where the first or last node lies beyond a face
  bool whole = true;         ///< none does

  [[gnu::always_inline]] StencilNodes(const Grid<S>& grid, const std::int32_t (*anchor)[chunk_size], int particle) {
    std::ptrdiff_t along[D][K];
    for (int d = 0; d < D; ++d) {
      const int first = anchor[d][particle] - shapes::nodes_before<K>, last = first + K - 1;
      beyond[d] = first < 0 ? -1 : last > grid.cells(d) ? 1 : 0;
      whole = whole && beyond[d] == 0;
      for (int k = 0; k < K; ++k) along[d][k] = std::ptrdiff_t(first + k) * (d == 0 ? 1 : grid.stride(d));
    }
    if (!whole) [[unlikely]]
      for (int d = 0; d < D; ++d)
        for (int k = 0; k < K; ++k)
          along[d][k] =
              std::ptrdiff_t(std::clamp(anchor[d][particle] - shapes::nodes_before<K> + k, 0, grid.cells(d))) *
              grid.stride(d);
    for (int r = 0; r < rows; ++r) {
      row[r] = D > 1 ? along[D > 1][r % K] : 0;
      if constexpr (D > 2) row[r] += along[2][r / K];
    }
    for (int k = 0; k < K; ++k) in_row[k] = along[0][k];
  }
  /// Calls f(I, node) for every node of the stencil, with I known at compile time.
  template <class F>
  [[gnu::always_inline]] void for_each(const F& f) const {
    if (whole) [[likely]] {
      shapes::unrolled<rows * K>([&](auto I) __attribute__((always_inline)) {
        f(I, std::size_t(row[I / K] + in_row[0]) + std::size_t(I % K));
      });
    } else {
      shapes::unrolled<rows * K>([&](auto I)
                                     __attribute__((always_inline)) { f(I, std::size_t(row[I / K] + in_row[I % K])); });
    }
  }
  /// Linear continuation, v_-1 = 2 v_0 - v_1, of nodal values.
  template <class Q>
  void continue_field(Q* n) const {
    at_faces([&](int a, int b, int c) { n[a] = n[b] + n[b] - n[c]; });
  }
  /// Its transpose: what nodes beyond a face have got goes to the two within.
  template <class Q>
  void fold_sums(Q* n) const {
    at_faces([&](int a, int b, int c) { n[b] += n[a] + n[a], n[c] -= n[a], n[a] = Q{}; });
  }

 private:
  template <class F>
  void at_faces(const F& f) const {
    if (whole) [[likely]]
      return;
    for (int d = 0, stride = 1; d < D; ++d, stride *= K) {
      if (beyond[d] == 0) continue;
      const int from = beyond[d] < 0 ? 0 : (K - 1) * stride, inward = beyond[d] < 0 ? stride : -stride;
      for (int a = 0; a < shapes::power(K, D); ++a)
        if (a / stride % K == 0) f(a + from, a + from + inward, a + from + 2 * inward);
    }
  }
};

/// Sum over the modes of the last axis, `n` apart.
template <int D, int K, class Q, class W>
[[gnu::always_inline]] inline void along_axis(const Q* mode, int n, const W& w, int p, Q& out) {
  constexpr int first = K == 2 ? 0 : 1;
  if constexpr (K == 2) {
    out = w.weight[D - 1][0][p] * mode[0];
  } else {
    out = mode[0];
  }
  shapes::unrolled<K - 1>([&](auto k) __attribute__((always_inline)) {
    out += w.weight[D - 1][k + 1 - first][p] * mode[(k + 1) * n];
  });
}
/// Value of a field from its modes, and its slopes along every axis, per cell. Words go out by reference: returned,
/// wide ones would make the interface of a program depend on its instruction set.
template <int D, int K, class Q, class W>
[[gnu::always_inline]] inline void value_of(const Q* mode, const W& w, int p, Q& value) {
  if constexpr (D == 0) {
    value = mode[0];
  } else {
    constexpr int n = shapes::power(K, D - 1);
    Q line[n];
    shapes::unrolled<n>([&](auto a) __attribute__((always_inline)) { along_axis<D, K>(mode + a, n, w, p, line[a]); });
    value_of<D - 1, K>(line, w, p, value);
  }
}
template <int D, int K, class Q, class W>
[[gnu::always_inline]] inline void value_of(const Q* mode, const W& w, int p, Q& value, Q* slopes) {
  if constexpr (D == 0) {
    value = mode[0];
  } else {
    constexpr int n = shapes::power(K, D - 1);
    Q line[n], slope[n];
    shapes::unrolled<n>([&](auto a) __attribute__((always_inline)) {
      along_axis<D, K>(mode + a, n, w, p, line[a]);
      if constexpr (K == 2) {
        slope[a] = mode[n + a] - mode[a];
      } else {
        slope[a] = w.slope[D - 1][0][p] * mode[n + a];
        shapes::unrolled<K - 2>([&](auto k) __attribute__((always_inline)) {
          slope[a] += w.slope[D - 1][k + 1][p] * mode[(k + 2) * n + a];
        });
      }
    });
    value_of<D - 1, K>(slope, w, p, slopes[D - 1]);
    value_of<D - 1, K>(line, w, p, value, slopes);
  }
}
/// The transposes: what a value, or a value and slopes, are in modes.
template <int D, int K, class Q, class W>
[[gnu::always_inline]] inline void modes_of(const Q& value, const W& w, int p, Q* mode) {
  if constexpr (D == 0) {
    mode[0] = value;
  } else {
    constexpr int n = shapes::power(K, D - 1), first = K == 2 ? 0 : 1;
    modes_of<D - 1, K>(value, w, p, mode);
    shapes::unrolled<n>([&](auto a) __attribute__((always_inline)) {
      shapes::unrolled<K - 1>([&](auto k) __attribute__((always_inline)) {
        mode[(k + 1) * n + a] = w.weight[D - 1][k + 1 - first][p] * mode[a];
      });
      if constexpr (K == 2) mode[a] *= w.weight[D - 1][0][p];
    });
  }
}
template <int D, int K, class Q, class W>
[[gnu::always_inline]] inline void modes_of(const Q& value, const Q* slopes, const W& w, int p, Q* mode) {
  if constexpr (D == 0) {
    mode[0] = value;
  } else {
    constexpr int n = shapes::power(K, D - 1);
    Q slope[n];
    modes_of<D - 1, K>(value, slopes, w, p, mode);
    modes_of<D - 1, K>(slopes[D - 1], w, p, slope);
    shapes::unrolled<n>([&](auto a) __attribute__((always_inline)) {
      if constexpr (K == 2) {
        mode[n + a] = slope[a] + w.weight[D - 1][1][p] * mode[a];
        mode[a] = w.weight[D - 1][0][p] * mode[a] - slope[a];
      } else {
        shapes::unrolled<K - 1>([&](auto k) __attribute__((always_inline)) {
          mode[(k + 1) * n + a] = w.slope[D - 1][k][p] * slope[a] + w.weight[D - 1][k][p] * mode[a];
        });
      }
    });
  }
}

}  // namespace detail
}  // namespace mpm
