// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

// The tensors a constitutive law sees: always three-dimensional, plain aggregates of a lane type V. V = double (or
// float) is one particle; a SIMD vector is several at once. Laws are written branch-free with `select`, so that one
// source serves both.
namespace mpm {

/// Branch-free choice: `yes` where `condition` holds, else `no`. Overloaded for SIMD lanes.
template <class V>
constexpr V select(bool condition, const V& yes, const V& no) {
  return condition ? yes : no;
}
/// Whether a condition holds anywhere: lets a law skip work that no lane needs. Overloaded for SIMD lanes.
constexpr bool any(bool condition) {
  return condition;
}
constexpr float max(float a, float b) {
  return a > b ? a : b;
}
constexpr double max(double a, double b) {
  return a > b ? a : b;
}
constexpr float min(float a, float b) {
  return a < b ? a : b;
}
constexpr double min(double a, double b) {
  return a < b ? a : b;
}
using std::abs;
using std::cbrt;
using std::exp;
using std::log;
using std::pow;
using std::sqrt;

/// Symmetric 3x3 tensor (stress, strain rate); components in the order xx yy zz xy yz zx.
template <class V>
struct SymmetricTensor {
  V xx{}, yy{}, zz{}, xy{}, yz{}, zx{};

  static constexpr SymmetricTensor spherical(const V& p) { return {p, p, p, V(0), V(0), V(0)}; }

  constexpr SymmetricTensor& operator+=(const SymmetricTensor& o) {
    xx += o.xx, yy += o.yy, zz += o.zz, xy += o.xy, yz += o.yz, zx += o.zx;
    return *this;
  }
  friend constexpr SymmetricTensor operator+(SymmetricTensor a, const SymmetricTensor& b) { return a += b; }
  friend constexpr SymmetricTensor operator-(const SymmetricTensor& a, const SymmetricTensor& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
  }
  friend constexpr SymmetricTensor operator*(const V& s, const SymmetricTensor& a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
  }
};

/// General 3x3 tensor (velocity gradient, deformation gradient, rotation), row-major.
template <class V>
struct Tensor {
  V xx{}, xy{}, xz{}, yx{}, yy{}, yz{}, zx{}, zy{}, zz{};

  static constexpr Tensor identity() { return {V(1), V(0), V(0), V(0), V(1), V(0), V(0), V(0), V(1)}; }

  friend constexpr Tensor operator+(const Tensor& a, const Tensor& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yx + b.yx, a.yy + b.yy,
            a.yz + b.yz, a.zx + b.zx, a.zy + b.zy, a.zz + b.zz};
  }
  friend constexpr Tensor operator*(const V& s, const Tensor& a) {
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yx, s * a.yy, s * a.yz, s * a.zx, s * a.zy, s * a.zz};
  }
  friend constexpr Tensor operator*(const Tensor& a, const Tensor& b) {
    return {a.xx * b.xx + a.xy * b.yx + a.xz * b.zx, a.xx * b.xy + a.xy * b.yy + a.xz * b.zy,
            a.xx * b.xz + a.xy * b.yz + a.xz * b.zz, a.yx * b.xx + a.yy * b.yx + a.yz * b.zx,
            a.yx * b.xy + a.yy * b.yy + a.yz * b.zy, a.yx * b.xz + a.yy * b.yz + a.yz * b.zz,
            a.zx * b.xx + a.zy * b.yx + a.zz * b.zx, a.zx * b.xy + a.zy * b.yy + a.zz * b.zy,
            a.zx * b.xz + a.zy * b.yz + a.zz * b.zz};
  }
};

template <class V>
constexpr V trace(const SymmetricTensor<V>& a) {
  return a.xx + a.yy + a.zz;
}
template <class V>
constexpr V trace(const Tensor<V>& a) {
  return a.xx + a.yy + a.zz;
}
template <class V>
constexpr Tensor<V> transpose(const Tensor<V>& a) {
  return {a.xx, a.yx, a.zx, a.xy, a.yy, a.zy, a.xz, a.yz, a.zz};
}
template <class V>
constexpr V determinant(const Tensor<V>& a) {
  return a.xx * (a.yy * a.zz - a.yz * a.zy) - a.xy * (a.yx * a.zz - a.yz * a.zx) + a.xz * (a.yx * a.zy - a.yy * a.zx);
}
/// Symmetric part, e.g. the rate of deformation D of a velocity gradient L.
template <class V>
constexpr SymmetricTensor<V> symmetric(const Tensor<V>& a) {
  const V half(0.5);
  return {a.xx, a.yy, a.zz, half * (a.xy + a.yx), half * (a.yz + a.zy), half * (a.zx + a.xz)};
}
template <class V>
constexpr SymmetricTensor<V> deviator(const SymmetricTensor<V>& a) {
  return a - SymmetricTensor<V>::spherical(trace(a) * V(1.0 / 3.0));
}
/// Double contraction a : b.
template <class V>
constexpr V inner(const SymmetricTensor<V>& a, const SymmetricTensor<V>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + V(2) * (a.xy * b.xy + a.yz * b.yz + a.zx * b.zx);
}
/// Q a Q^T of a symmetric tensor.
template <class V>
constexpr SymmetricTensor<V> rotated(const SymmetricTensor<V>& a, const Tensor<V>& q) {
  const Tensor<V> full{a.xx, a.xy, a.zx, a.xy, a.yy, a.yz, a.zx, a.yz, a.zz};
  return symmetric(q * full * transpose(q));
}
/// Rotation of one step from the spin of `L` (Hughes & Winget 1980, the Cayley transform of W dt): orthogonal to
/// round-off for any step.
template <class V>
constexpr Tensor<V> step_rotation(const Tensor<V>& L, const V& dt) {
  const V quarter = V(0.25) * dt;
  const V a = quarter * (L.zy - L.yz), b = quarter * (L.xz - L.zx), c = quarter * (L.yx - L.xy);
  const V f = V(2) / (V(1) + a * a + b * b + c * c);
  return {V(1) - f * (b * b + c * c), f * (a * b - c), f * (a * c + b), f * (a * b + c),
          V(1) - f * (a * a + c * c), f * (b * c - a), f * (a * c - b), f * (b * c + a),
          V(1) - f * (a * a + b * b)};
}
/// `a` turned with the spin of `L` over dt, Q a Q^T with Q = step_rotation(L, dt); a spin about z alone costs a third.
template <class V>
constexpr SymmetricTensor<V> turned(const SymmetricTensor<V>& a, const Tensor<V>& L, const V& dt) {
  if (any(L.zy != L.yz || L.xz != L.zx)) return rotated(a, step_rotation(L, dt));
  const V half_angle = V(0.25) * dt * (L.yx - L.xy), f = V(2) / (V(1) + half_angle * half_angle);
  const V sine = f * half_angle, cosine = V(1) - sine * half_angle;
  const V cc = cosine * cosine, ss = sine * sine, cs = cosine * sine, twice = V(2) * cs * a.xy;
  return {cc * a.xx + ss * a.yy - twice,         ss * a.xx + cc * a.yy + twice, a.zz,
          cs * (a.xx - a.yy) + (cc - ss) * a.xy, sine * a.zx + cosine * a.yz,   cosine * a.zx - sine * a.yz};
}
/// Von Mises equivalent stress sqrt(3 J2).
template <class V>
constexpr V equivalent_stress(const SymmetricTensor<V>& stress) {
  const auto s = deviator(stress);
  return sqrt(V(1.5) * inner(s, s));
}

}  // namespace mpm
