// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/tensor.hpp>
#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

// Several particles at once. Laws and shape functions are templates on their number type; with `Lanes` for it they work
// on a SIMD register of particles, with a floating-point type on one, and that is the plain reference.
namespace mpm {

/// Bytes of a SIMD register of the machine compiled for. Wider vectors than it has would be split badly.
#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif

/// A vector of N scalars that the compiler itself knows: arithmetic acts on each.
template <class T, int N>
struct NativeVector {
  typedef T Type __attribute__((vector_size(N * int(sizeof(T)))));
};
template <class T, int N>
using Native = typename NativeVector<T, N>::Type;

/// One condition a lane.
template <class T, int N>
struct LaneMask {
  using Integer = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
  Native<Integer, N> v;

  friend LaneMask operator&&(const LaneMask& a, const LaneMask& b) { return {a.v & b.v}; }
  friend LaneMask operator||(const LaneMask& a, const LaneMask& b) { return {a.v | b.v}; }
  friend LaneMask operator!(const LaneMask& a) { return {~a.v}; }
};

/// N scalars of N particles.
template <class T, int N>
struct Lanes {
  using Scalar = T;
  using Mask = LaneMask<T, N>;
  using Integers = Native<std::int32_t, N>;
  static constexpr int size = N;

  Native<T, N> v;  ///< no number until it is given one, as with T itself; V{} is zero

  Lanes() = default;
  Lanes(T value) : v(value - Native<T, N>{}) {}
  Lanes(Native<T, N> values) : v(values) {}
  template <class U>
  requires(std::is_arithmetic_v<U> && !std::is_same_v<U, T>) Lanes(U value) : Lanes(T(value)) {}

  static Lanes load(const T* from) {
    Lanes a;
    std::memcpy(&a.v, from, sizeof(a.v));
    return a;
  }
  void store(T* to) const { std::memcpy(to, &v, sizeof(v)); }
  T operator[](int lane) const { return v[lane]; }

  Lanes operator-() const { return -v; }
  Lanes& operator+=(const Lanes& o) { return v += o.v, *this; }
  Lanes& operator-=(const Lanes& o) { return v -= o.v, *this; }
  Lanes& operator*=(const Lanes& o) { return v *= o.v, *this; }
  Lanes& operator/=(const Lanes& o) { return v /= o.v, *this; }
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.v + b.v; }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.v - b.v; }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.v * b.v; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.v / b.v; }
  friend Mask operator<(const Lanes& a, const Lanes& b) { return {a.v < b.v}; }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return {a.v > b.v}; }
  friend Mask operator<=(const Lanes& a, const Lanes& b) { return {a.v <= b.v}; }
  friend Mask operator>=(const Lanes& a, const Lanes& b) { return {a.v >= b.v}; }
  friend Mask operator!=(const Lanes& a, const Lanes& b) { return {a.v != b.v}; }
};

namespace detail {
/// v[0], v[1], ... v[N - 1] combined by halves: f of two vectors of N / 2, then N / 4, ... and last of two numbers.
template <int N, class Vector, class F>
[[gnu::always_inline]] inline auto by_halves(const Vector& v, const F& f) {
  if constexpr (N == 2) {
    return f(v[0], v[1]);
  } else {
    return [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
      return by_halves<N / 2>(f(__builtin_shufflevector(v, v, I...), __builtin_shufflevector(v, v, (N / 2 + I)...)), f);
    }
    (std::make_integer_sequence<int, N / 2>());
  }
}
}  // namespace detail

template <class T, int N>
Lanes<T, N> select(const LaneMask<T, N>& condition, const Lanes<T, N>& yes, const Lanes<T, N>& no) {
  return condition.v ? yes.v : no.v;
}
template <class Integers>
bool any_of(const Integers& found) {
  return detail::by_halves<int(sizeof(found) / sizeof(found[0]))>(found, [](auto a, auto b) { return a | b; }) != 0;
}
template <class T, int N>
bool any(const LaneMask<T, N>& condition) {
  return any_of(condition.v);
}
template <class T, int N>
Lanes<T, N> max(const Lanes<T, N>& a, const Lanes<T, N>& b) {
  return a.v > b.v ? a.v : b.v;
}
template <class T, int N>
Lanes<T, N> min(const Lanes<T, N>& a, const Lanes<T, N>& b) {
  return a.v < b.v ? a.v : b.v;
}
template <class T, int N>
Lanes<T, N> abs(const Lanes<T, N>& a) {
  return max(a, -a);
}

namespace detail {
/// f of an Eigen array of the lanes: Eigen brings the vectorised elementary functions.
template <class T, int N, class F>
Lanes<T, N> by_eigen(const Lanes<T, N>& a, const F& f) {
  Eigen::Array<T, N, 1> x;
  a.store(x.data());
  x = f(x);
  return Lanes<T, N>::load(x.data());
}
}  // namespace detail

template <class T, int N>
Lanes<T, N> sqrt(const Lanes<T, N>& a) {
  Lanes<T, N> root;
  for (int k = 0; k < N; ++k) root.v[k] = std::sqrt(a.v[k]);
  return root;
}
template <class T, int N>
Lanes<T, N> exp(const Lanes<T, N>& a) {
  return detail::by_eigen(a, [](const auto& x) { return x.exp(); });
}
template <class T, int N>
Lanes<T, N> log(const Lanes<T, N>& a) {
  return detail::by_eigen(a, [](const auto& x) { return x.log(); });
}
/// a^b of bases that are not negative.
template <class T, int N>
Lanes<T, N> pow(const Lanes<T, N>& a, const Lanes<T, N>& b) {
  const Lanes<T, N> zero(0), one(1);
  return select(a > zero, exp(b * log(a)), select(b > zero, zero, one));
}

template <class T, int N>
Lanes<T, N> cbrt(const Lanes<T, N>& a) {
  return pow(a, Lanes<T, N>(1.0 / 3));
}

/// Lanes that fill a register.
template <class T>
using LanesOf = Lanes<T, register_bytes / int(sizeof(T))>;

/// Reads one number, of the same type or another, or a register of them.
template <class V, class T>
V load(const T* from) {
  if constexpr (std::is_arithmetic_v<V>) {
    return V(*from);
  } else {
    return V::load(from);
  }
}
template <class V, class T>
void store(const V& value, T* to) {
  if constexpr (std::is_same_v<V, T>) {
    *to = value;
  } else {
    value.store(to);
  }
}

/// How many numbers V holds, and the k-th of them.
template <class V>
inline constexpr int lane_count = 1;
template <class T, int N>
inline constexpr int lane_count<Lanes<T, N>> = N;
template <class V>
auto lane(const V& value, int k) {
  if constexpr (lane_count<V> == 1) {
    return value;
  } else {
    return value[k];
  }
}

/// The larger of two numbers, or that which is none.
template <class V>
[[gnu::always_inline]] inline V larger_or_nan(const V& a, const V& b) {
  return select(b <= a || a != a, a, b);
}
/// Largest and sum of the numbers that V holds; NaN if one is.
template <class V>
auto largest(const V& a) {
  if constexpr (lane_count<V> == 1) {
    return a;
  } else {
    return detail::by_halves<V::size>(a.v, [](const auto& x, const auto& y) { return y <= x || x != x ? x : y; });
  }
}
template <class V>
auto total(const V& a) {
  if constexpr (lane_count<V> == 1) {
    return a;
  } else {
    return detail::by_halves<V::size>(a.v, [](const auto& x, const auto& y) { return x + y; });
  }
}
/// Which lanes are among the first `count`.
template <class V>
auto first_lanes(int count) {
  V index;
  for (int k = 0; k < V::size; ++k) index.v[k] = typename V::Scalar(k);
  return index < V(count);
}

/// Towards zero.
template <class T, int N>
Native<std::int32_t, N> truncated(const Lanes<T, N>& a) {
  return __builtin_convertvector(a.v, Native<std::int32_t, N>);
}
template <class V>
V as_lanes(const typename V::Integers& a) {
  return __builtin_convertvector(a, Native<typename V::Scalar, V::size>);
}

}  // namespace mpm
