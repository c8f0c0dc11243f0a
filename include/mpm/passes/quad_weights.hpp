// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/chunk.hpp>
#include <mpm/shapes/cpdi_quad.hpp>

namespace mpm::detail {

/// The quadrilaterals of a register of particles, the last of which stands in for those beyond `size`: corners as seen
/// from the first, area, weights of the corners, and the gradients of the first two; those of the opposite corners are
/// their negatives. See CpdiQuad::weights.
template <class V>
struct QuadWeights {
  V origin[2], x[4], y[4], area, weight[4], gradient[2][2];

  template <class Shape>
  [[gnu::always_inline]] QuadWeights(const Shape& shape, std::size_t first, int size) {
    using Scalar = typename V::Scalar;
    Word<Scalar> low[V::size], high[V::size];  // corners 0 and 1, 2 and 3; of corner 0 its place
    shapes::unrolled<V::size>([&](auto k) __attribute__((always_inline)) {
      const auto& quad = shape.quad[first + std::size_t(std::min(int(k), size - 1))];
      Word<double> a, b;
      join(shape.corner[quad[0]].data(), shape.corner[quad[1]].data(), a);
      join(shape.corner[quad[2]].data(), shape.corner[quad[3]].data(), b);
      const Word<double> zero{};
      low[k] = __builtin_convertvector(a - __builtin_shufflevector(a, zero, 4, 4, 0, 1), Word<Scalar>);
      high[k] = __builtin_convertvector(b - __builtin_shufflevector(a, a, 0, 1, 0, 1), Word<Scalar>);
    });
    const auto a = to_lanes<V>(low), b = to_lanes<V>(high);
    origin[0] = a[0], origin[1] = a[1];
    x[0] = y[0] = V(0);
    x[1] = a[2], y[1] = a[3];
    x[2] = b[0], y[2] = b[1], x[3] = b[2], y[3] = b[3];
    area = V(0.5) * ((x[2] - x[0]) * (y[3] - y[1]) - (x[3] - x[1]) * (y[2] - y[0]));
    const V p = (x[3] - x[0]) * (y[1] - y[2]) - (x[1] - x[2]) * (y[3] - y[0]);
    const V q = (x[2] - x[3]) * (y[0] - y[1]) - (x[0] - x[1]) * (y[2] - y[3]);
    const V inverse = V(1) / area, s = V(1.0 / 24) * inverse, g = V(0.5) * inverse, six = V(6) * area;
    weight[0] = (six - p - q) * s, weight[1] = (six - p + q) * s;
    weight[2] = (six + p + q) * s, weight[3] = (six + p - q) * s;
    gradient[0][0] = (y[1] - y[3]) * g, gradient[0][1] = (x[3] - x[1]) * g;
    gradient[1][0] = (y[2] - y[0]) * g, gradient[1][1] = (x[0] - x[2]) * g;
  }
};

}  // namespace mpm::detail

namespace mpm {

template <class Body, class V>
[[gnu::always_inline]] inline bool CpdiQuad::domain_modes(const Body&, std::size_t p,
                                                          const Grid<typename Body::SpaceType>& grid,
                                                          DomainModes<V>& out) const {
  const detail::QuadWeights<V> w(*this, p, int(std::min<std::size_t>(V::size, quad.size() - p)));
  const V h(grid.cell());
  const V g1[2] = {w.gradient[0][0] * h, w.gradient[0][1] * h}, g2[2] = {w.gradient[1][0] * h, w.gradient[1][1] * h};
  V x[4], y[4];
  for (int c = 0; c < 4; ++c) x[c] = w.origin[0] + w.x[c], y[c] = w.origin[1] + w.y[c];
  const auto centroid = [&](const V* at) {
    return w.weight[0] * at[0] + w.weight[1] * at[1] + (w.weight[2] * at[2] + w.weight[3] * at[3]);
  };
  return Cpdi::modes_of_corners(grid, centroid(x), centroid(y), x, y, w.weight, g1, g2, out);
}

}  // namespace mpm
