// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/tensor.hpp>

namespace mpm {

/// Principal values of a symmetric tensor, first >= second >= third.
template <class V>
struct PrincipalValues {
  V first{}, second{}, third{};
};

namespace detail {

/// cos(acos(c)/3) for c in [-1, 1]. With s = cos(acos(c)/4) from two half-angle steps it is the Chebyshev function
/// T_{4/3}(s), so smooth on [1/sqrt 2, 1] that degree 8 meets it to 2e-14; unlike acos and cos it runs on every lane.
template <class V>
V cosine_of_third(const V& c) {
  const V s = sqrt(V(0.5) + V(0.5) * sqrt(V(0.5) + V(0.5) * c)) - V(0.8535533905932737);
  V sum(0.00025566414067212945);
  sum = sum * s + V(-0.00060009177623324692);
  sum = sum * s + V(0.0014620763451738503);
  sum = sum * s + V(-0.0038388315345432634);
  sum = sum * s + V(0.011204942140204682);
  sum = sum * s + V(-0.039964663449249871);
  sum = sum * s + V(0.2466801560512567);
  sum = sum * s + V(1.7079656593309742);
  return sum * s + V(0.74470437877581985);
}

}  // namespace detail

/// Principal values in closed form. Near a double value the two that meet are exact to the square root of the
/// round-off only (inherent in the cubic); their sum and the third keep full accuracy.
template <class V>
PrincipalValues<V> principal_values(const SymmetricTensor<V>& a) {
  const V mean = trace(a) * V(1.0 / 3.0);
  const auto s = deviator(a);
  const V radius = sqrt(inner(s, s) * V(1.0 / 6.0));  // sqrt(J2/3)
  const auto n = (V(1) / max(radius, V(1e-30))) * s;
  const V det =
      n.xx * (n.yy * n.zz - n.yz * n.yz) - n.xy * (n.xy * n.zz - n.yz * n.zx) + n.zx * (n.xy * n.yz - n.yy * n.zx);
  const V c = max(V(-1), min(V(1), V(0.5) * det));
  const V up = V(2) * radius * detail::cosine_of_third(c), down = V(2) * radius * detail::cosine_of_third(-c);
  return {mean + up, mean - up + down, mean - down};
}

/// (a - b I)(a - c I), symmetric because the factors commute. With b and c two principal values it is
/// (lone - b)(lone - c) times the projector n (x) n on the direction of the third, `lone`.
template <class V>
SymmetricTensor<V> shifted_product(const SymmetricTensor<V>& a, const V& b, const V& c) {
  return {(a.xx - b) * (a.xx - c) + a.xy * a.xy + a.zx * a.zx, (a.yy - b) * (a.yy - c) + a.xy * a.xy + a.yz * a.yz,
          (a.zz - b) * (a.zz - c) + a.zx * a.zx + a.yz * a.yz, a.xy * (a.xx + a.yy - b - c) + a.zx * a.yz,
          a.yz * (a.yy + a.zz - b - c) + a.xy * a.zx,          a.zx * (a.xx + a.zz - b - c) + a.xy * a.yz};
}

}  // namespace mpm
