// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/chunk.hpp>

namespace mpm {

/// A shape function of the plane whose weights on 3x3 nodes are no product of two axes, but has them in modes.
template <class Body>
concept HasDomainModes = requires(const Body b, const Grid<typename Body::SpaceType> g,
                                  DomainModes<typename Body::Lane> modes) {
  requires Body::dimension == 2;
  b.shape.domain_modes(b, std::size_t{}, g, modes);
};

/// A shape function that the passes in lanes serve.
template <class Body>
concept InModes = (HasModes<Body> || HasDomainModes<Body>)&&!mean_dilatation<typename Body::Shape>;

namespace detail {

/// The weights of a chunk of particles by the modes of the plane; that of the first is one, and it has no slope.
template <class S>
struct DomainWeights : ChunkAnchors<S> {
  using Scalar = typename S::Scalar;
  static constexpr int modes = DomainModes<LanesOf<Scalar>>::modes;
  static constexpr int mass_words = 3;
  alignas(64) Scalar weight[modes][chunk_size];
  alignas(64) Scalar slope[2][modes][chunk_size];

  /// Returns whether modes serve all of the `size` particles.
  template <class Body>
  [[gnu::always_inline]] bool compute(const Body& body, std::size_t begin, int size, const Grid<S>& grid) {
    using V = typename Body::Lane;
    bool fit = true;
    for (int l = 0; l < size; l += V::size) {
      DomainModes<V> m;
      fit = body.shape.domain_modes(body, begin + std::size_t(l), grid, m) && fit;
      for (int k = 1; k < modes; ++k) {
        m.weight[k].store(&weight[k][l]);
        for (int d = 0; d < 2; ++d) m.slope[d][k].store(&slope[d][k][l]);
      }
      typename V::Integers linear{};
      for (int d = 0; d < 2; ++d) this->store(l, d, m.anchor[d], grid, linear);
    }
    return fit;
  }
  template <class V>
  [[gnu::always_inline]] void weigh(int l, const V& m, Word<Scalar> (*words)[chunk_size]) const {
    for (int j = 0; j < 3; ++j) {
      V row[3];
      for (int i = 0; i < 3; ++i) row[i] = i + j == 0 ? m : m * V::load(&weight[3 * j + i][l]);
      to_words(row[0], row[1], row[2], V(0), &words[j][l]);
    }
  }
  [[gnu::always_inline]] void add_mass(const Word<Scalar> (*words)[chunk_size], int p, Word<Scalar>* rows) const {
    for (int j = 0; j < 3; ++j) rows[j] += words[j][p];
  }
};

template <class Body, class S = typename Body::SpaceType>
struct WeightsOf {
  using Type = ChunkWeights<S, Body::Shape::axis_nodes>;
};
template <HasDomainModes Body, class S>
struct WeightsOf<Body, S> {
  using Type = DomainWeights<S>;
};

template <int, int, class Q, class S>
[[gnu::always_inline]] inline void value_of(const Q* mode, const DomainWeights<S>& w, int p, Q& value) {
  value = mode[0];
  shapes::unrolled<DomainWeights<S>::modes - 1>([&](auto k) __attribute__((always_inline)) {
    value += w.weight[k + 1][p] * mode[k + 1];
  });
}
template <int D, int K, class Q, class S>
[[gnu::always_inline]] inline void value_of(const Q* mode, const DomainWeights<S>& w, int p, Q& value, Q* slopes) {
  value_of<D, K>(mode, w, p, value);
  for (int d = 0; d < 2; ++d) {
    slopes[d] = w.slope[d][1][p] * mode[1];
    shapes::unrolled<DomainWeights<S>::modes - 2>([&](auto k) __attribute__((always_inline)) {
      slopes[d] += w.slope[d][k + 2][p] * mode[k + 2];
    });
  }
}
template <int, int, class Q, class S>
[[gnu::always_inline]] inline void modes_of(const Q& value, const DomainWeights<S>& w, int p, Q* mode) {
  mode[0] = value;
  shapes::unrolled<DomainWeights<S>::modes - 1>([&](auto k) __attribute__((always_inline)) {
    mode[k + 1] = w.weight[k + 1][p] * value;
  });
}
template <int, int, class Q, class S>
[[gnu::always_inline]] inline void modes_of(const Q& value, const Q* slopes, const DomainWeights<S>& w, int p,
                                            Q* mode) {
  mode[0] = value;
  shapes::unrolled<DomainWeights<S>::modes - 1>([&](auto k) __attribute__((always_inline)) {
    mode[k + 1] = w.weight[k + 1][p] * value + w.slope[0][k + 1][p] * slopes[0] + w.slope[1][k + 1][p] * slopes[1];
  });
}

}  // namespace detail
}  // namespace mpm
