// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/lanes.hpp>
#include <mpm/shapes/tensor_product.hpp>
#include <algorithm>
#include <array>

// Tensor-product weights of several particles, in modes. Along one axis weights sum to one, so instead of the nodes a
// particle may see the anchor node N_0 and the differences N_k - N_0 of the others, weighted by 1 and the w_k:
// particles that share a stencil share the modes, and the first costs no multiplication. The anchor is a node whose
// weight stays away from zero; sums over the others keep their relative accuracy however small they are, and so do
// the velocities of nodes that a particle only just touches. Of two nodes neither is such an anchor: there the modes
// are the nodes.
namespace mpm {

/// One axis: the anchor node (of two nodes the lower, of three the middle, of four the second), and the weights of the
/// modes with their slopes by cell: w_0, w_1 of two nodes; of more, those of all nodes but the anchor, rising.
template <class V, int K>
struct AxisModes {
  static constexpr int stored = K == 2 ? 2 : K - 1;
  typename V::Integers anchor;
  std::array<V, stored> weight;
  std::array<V, stored> slope;
};

/// The modes of 3x3 nodes of the plane, 3 j + i with i along the first axis, whose weights are no product. Slopes are
/// by cell; those of the first mode are zero, and its weight is one.
template <class V>
struct DomainModes {
  static constexpr int modes = 9;
  typename V::Integers anchor[2];
  V weight[modes], slope[2][modes];
};

namespace shapes {

/// f(0), f(1), ... f(N - 1) with the index known at compile time.
template <int N, class F>
[[gnu::always_inline]] inline void unrolled(const F& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
    (f(std::integral_constant<int, I>{}), ...);
  }
  (std::make_integer_sequence<int, N>());
}

/// Nodes of a K-node stencil that lie before its anchor.
template <int K>
inline constexpr int nodes_before = K > 2 ? 1 : 0;

template <class V>
typename V::Integers cell_of(const V& xi, int cells) {
  const auto cell = truncated(xi);
  const typename V::Integers last = typename V::Integers{} + (cells - 1);
  return cell < last ? cell : last;
}
/// The hat; see hat_axis.
template <class V>
[[gnu::always_inline]] inline void hat_modes(const V& xi, int cells, AxisModes<V, 2>& out) {
  out.anchor = cell_of(xi, cells);
  const V f = xi - as_lanes<V>(out.anchor);
  out.weight[0] = V(1) - f, out.weight[1] = f;
  out.slope[0] = V(-1), out.slope[1] = V(1);
}
/// The hat averaged over a box of half size `l` <= 1/2; see gimp_axis.
template <class V>
[[gnu::always_inline]] inline void gimp_modes(const V& xi, const V& l, AxisModes<V, 3>& out) {
  out.anchor = truncated(xi + V(0.5));
  const V r = xi - as_lanes<V>(out.anchor), inside = max(-l, min(l, r));
  const V t = l - inside, u = l + inside, quarter = V(0.25) / l;
  out.weight[0] = t * (t + V(2) * max(V(0), -l - r)) * quarter;
  out.weight[1] = u * (u + V(2) * max(V(0), r - l)) * quarter;
  out.slope[0] = V(-2) * t * quarter, out.slope[1] = V(2) * u * quarter;
}
/// The cubic spline; see cubic_axis.
template <class V>
[[gnu::always_inline]] inline void cubic_modes(const V& xi, int cells, AxisModes<V, 4>& out) {
  out.anchor = cell_of(xi, cells);
  const V f = xi - as_lanes<V>(out.anchor), g = V(1) - f, sixth(1.0 / 6), half(0.5);
  out.weight[0] = g * g * g * sixth, out.weight[1] = V(4.0 / 6) - g * g * (V(1) - half * g);
  out.weight[2] = f * f * f * sixth;
  out.slope[0] = -half * g * g, out.slope[1] = g * (V(2) - V(1.5) * g), out.slope[2] = half * f * f;
}

/// What the nodes of one axis are in modes: n[0], n[stride], ... in rising order, in place.
template <int K, class Q>
[[gnu::always_inline]] inline void to_modes(Q* n, int stride) {
  if constexpr (K > 2) {
    const Q anchor = n[stride];
    n[stride] = n[0] - anchor;
    n[0] = anchor;
    for (int k = 2; k < K; ++k) n[k * stride] -= anchor;
  }
}
/// The transpose: sums by mode become sums by node.
template <int K, class Q>
[[gnu::always_inline]] inline void to_nodes(Q* m, int stride) {
  if constexpr (K > 2) {
    Q anchor = m[0] - m[stride];
    for (int k = 2; k < K; ++k) anchor -= m[k * stride];
    m[0] = m[stride];
    m[stride] = anchor;
  }
}
/// Both along every axis of a K^D stencil.
template <int D, int K, class Q>
[[gnu::always_inline]] inline void all_to_modes(Q* n) {
  unrolled<D>([&](auto d) __attribute__((always_inline)) {
    constexpr int stride = power(K, d);
    unrolled<power(K, D - 1)>([&](auto a) __attribute__((always_inline)) {
      to_modes<K>(n + a / stride * stride * K + a % stride, stride);
    });
  });
}
template <int D, int K, class Q>
[[gnu::always_inline]] inline void all_to_nodes(Q* n) {
  unrolled<D>([&](auto d) __attribute__((always_inline)) {
    constexpr int stride = power(K, d);
    unrolled<power(K, D - 1)>([&](auto a) __attribute__((always_inline)) {
      to_nodes<K>(n + a / stride * stride * K + a % stride, stride);
    });
  });
}

}  // namespace shapes
}  // namespace mpm
