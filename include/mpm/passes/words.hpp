// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/lanes.hpp>
#include <mpm/shapes/modes.hpp>
#include <array>
#include <cstring>
#include <limits>

// Particles' columns as lanes, a particle or a node in each, and as words, a particle or a node a word.
namespace mpm::detail {

/// Four numbers of one node or particle, in one SIMD word.
template <class T>
using Word = Native<T, 4>;

/// Its numbers without their signs.
template <class T>
[[gnu::always_inline]] inline void magnitude(const Word<T>& a, Word<T>& out) {
  using Integer = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
  Native<Integer, 4> bits;
  std::memcpy(&bits, &a, sizeof(a));
  bits &= std::numeric_limits<Integer>::max();
  std::memcpy(&out, &bits, sizeof(out));
}
/// Two vectors of the plane in one word.
template <class T>
[[gnu::always_inline]] inline void join(const T* a, const T* b, Word<T>& to) {
  Native<T, 2> low, high;
  std::memcpy(&low, a, sizeof(low));
  std::memcpy(&high, b, sizeof(high));
  to = __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
/// Transposes the 4x4 blocks that lie side by side in four rows of N.
template <class Row, int... I>
[[gnu::always_inline]] inline void transpose_blocks(Row& a, Row& b, Row& c, Row& d, std::integer_sequence<int, I...>) {
  constexpr int N = sizeof...(I);
  // Within each block: entry i of the first row where it is even, or below 2, else the entry before of the second.
  const Row ab_even = __builtin_shufflevector(a, b, (I % 2 == 0 ? I : N + I - 1)...);
  const Row ab_odd = __builtin_shufflevector(a, b, (I % 2 == 0 ? I + 1 : N + I)...);
  const Row cd_even = __builtin_shufflevector(c, d, (I % 2 == 0 ? I : N + I - 1)...);
  const Row cd_odd = __builtin_shufflevector(c, d, (I % 2 == 0 ? I + 1 : N + I)...);
  a = __builtin_shufflevector(ab_even, cd_even, (I % 4 < 2 ? I : N + I - 2)...);
  b = __builtin_shufflevector(ab_odd, cd_odd, (I % 4 < 2 ? I : N + I - 2)...);
  c = __builtin_shufflevector(ab_even, cd_even, (I % 4 < 2 ? I + 2 : N + I)...);
  d = __builtin_shufflevector(ab_odd, cd_odd, (I % 4 < 2 ? I + 2 : N + I)...);
}
/// Four columns of lanes become one word a particle, and back.
template <class V, class T = typename V::Scalar>
[[gnu::always_inline]] inline void to_words(const V& a, const V& b, const V& c, const V& d, Word<T>* to) {
  if constexpr (V::size < 4) {
    for (int k = 0; k < V::size; ++k) to[k] = Word<T>{a[k], b[k], c[k], d[k]};
  } else {
    Native<T, V::size> row[4] = {a.v, b.v, c.v, d.v};
    transpose_blocks(row[0], row[1], row[2], row[3], std::make_integer_sequence<int, V::size>());
    shapes::unrolled<V::size>([&](auto k) __attribute__((always_inline)) {
      constexpr int first = k / 4 * 4;
      to[k] = __builtin_shufflevector(row[k % 4], row[k % 4], first, first + 1, first + 2, first + 3);
    });
  }
}
/// Words `Step` apart, side by side in one vector.
template <int Count, int Step, class T>
[[gnu::always_inline]] inline void side_by_side(const Word<T>* from, Native<T, 4 * Count>& to) {
  if constexpr (Count == 1) {
    to = *from;
  } else {
    Native<T, 2 * Count> low, high;
    side_by_side<Count / 2, Step, T>(from, low);
    side_by_side<Count / 2, Step, T>(from + Count / 2 * Step, high);
    [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
      to = __builtin_shufflevector(low, high, I...);
    }
    (std::make_integer_sequence<int, 4 * Count>());
  }
}
template <class V, class T = typename V::Scalar>
[[gnu::always_inline]] inline std::array<V, 4> to_lanes(const Word<T>* from) {
  std::array<V, 4> columns;
  if constexpr (V::size < 4) {
    for (int c = 0; c < 4; ++c)
      for (int k = 0; k < V::size; ++k) columns[c].v[k] = from[k][c];
  } else {
    for (int k = 0; k < 4; ++k) side_by_side<V::size / 4, 4, T>(from + k, columns[std::size_t(k)].v);
    transpose_blocks(columns[0].v, columns[1].v, columns[2].v, columns[3].v,
                     std::make_integer_sequence<int, V::size>());
  }
  return columns;
}

}  // namespace mpm::detail
