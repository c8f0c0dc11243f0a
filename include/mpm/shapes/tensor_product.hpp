// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/error.hpp>
#include <mpm/grid.hpp>
#include <mpm/stencil.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace mpm::shapes {

/// Linear hat at `xi` cells from the origin: two nodes.
template <class Scalar>
AxisStencil<Scalar, 2> hat_axis(Scalar xi, int cells) {
  const int first = std::min(int(xi), cells - 1);
  const Scalar f = xi - Scalar(first);
  return {first, {1 - f, f}, {-1, 1}};
}

/// Hat averaged over a box of half size `l` <= 1/2 about `xi`, both in cells (Bardenhagen & Kober 2004): the nearest
/// node and its two neighbours. Theirs come from how far the box reaches past the nearest node, so that a node which it
/// barely touches gets a weight that goes with the square of the gradient, to the last bit; else the mass there would
/// be round-off, and the acceleration anything.
template <class Scalar>
AxisStencil<Scalar, 3> gimp_axis(Scalar xi, Scalar l) {
  const Scalar nearest = std::floor(xi + Scalar(0.5)), r = xi - nearest;
  const Scalar inside = std::clamp(r, -l, l), t = l - inside, u = l + inside, quarter = Scalar(0.25) / l;
  const Scalar below = t * (t + 2 * std::max(Scalar(0), -l - r)) * quarter;
  const Scalar above = u * (u + 2 * std::max(Scalar(0), r - l)) * quarter;
  return {
      int(nearest) - 1, {below, 1 - below - above, above}, {-2 * t * quarter, 2 * (t - u) * quarter, 2 * u * quarter}};
}

/// Integral of the hat from -1 to u.
template <class Scalar>
Scalar hat_integral(Scalar u) {
  u = std::clamp(u, Scalar(-1), Scalar(1));
  return u < 0 ? Scalar(0.5) * (1 + u) * (1 + u) : 1 - Scalar(0.5) * (1 - u) * (1 - u);
}

/// The same for a box of any size: the difference of the hat's integrals at its two ends, mirrored where that keeps it
/// from being one of numbers near 1.
template <int MaxNodes, class Scalar>
WideAxisStencil<Scalar, MaxNodes> wide_gimp_axis(Scalar xi, Scalar l) {
  WideAxisStencil<Scalar, MaxNodes> a;
  const Scalar low = xi - l, high = xi + l, scale = 1 / (2 * l);
  a.first = int(std::floor(low));
  a.size = std::min(int(std::floor(high)) - a.first + 2, MaxNodes);
  for (int k = 0; k < a.size; ++k) {
    const Scalar node = Scalar(a.first + k);
    const Scalar u = low - node, v = high - node;
    a.w[k] = (u + v < 0 ? hat_integral(v) - hat_integral(u) : hat_integral(-u) - hat_integral(-v)) * scale;
    a.dw[k] = (std::max(Scalar(0), 1 - std::abs(v)) - std::max(Scalar(0), 1 - std::abs(u))) * scale;
  }
  return a;
}

/// Product of axis stencils; nodes beyond a face are folded onto it.
template <class S, class Axis, class Out>
void tensor_product(const std::array<Axis, S::dimension>& axis, const Grid<S>& grid, Out& out) {
  using Scalar = typename S::Scalar;
  constexpr int dimension = S::dimension;
  const Scalar inverse = grid.inverse_cell();
  const auto index = [&](int d, int k) { return std::clamp(axis[d].first + k, 0, grid.cells(d)) * grid.stride(d); };
  for (int k = 0; k < (dimension > 2 ? axis[dimension - 1].size : 1); ++k) {
    for (int j = 0; j < (dimension > 1 ? axis[dimension > 1].size : 1); ++j) {
      for (int i = 0; i < axis[0].size; ++i) {
        if constexpr (dimension == 1) {
          out.add(index(0, i), axis[0].w[i], {axis[0].dw[i] * inverse});
        } else if constexpr (dimension == 2) {
          const Scalar wx = axis[0].w[i], wy = axis[1].w[j];
          out.add(index(0, i) + index(1, j), wx * wy, {axis[0].dw[i] * wy * inverse, wx * axis[1].dw[j] * inverse});
        } else {
          const Scalar wx = axis[0].w[i], wy = axis[1].w[j], wz = axis[2].w[k];
          out.add(index(0, i) + index(1, j) + index(2, k), wx * wy * wz,
                  {axis[0].dw[i] * wy * wz * inverse, wx * axis[1].dw[j] * wz * inverse,
                   wx * wy * axis[2].dw[k] * inverse});
        }
      }
    }
  }
}

/// Throws Error unless the half edges are positive and at most `largest`, in m.
template <class Body>
void require_half_size(const Body& body, const std::array<double, 3>& half_size, double largest) {
  for (int d = 0; d < Body::dimension; ++d) {
    if (half_size[d] > 0 && half_size[d] <= largest) continue;
    std::ostringstream text;
    text << "body " << body.name << ": shape.half_size[" << d << "] is " << half_size[d] << " m and must be positive"
         << (std::isfinite(largest) ? " and at most half a cell" : "")
         << "; set it to half the spacing of the particles";
    throw Error(text.str());
  }
}

constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

}  // namespace mpm::shapes
