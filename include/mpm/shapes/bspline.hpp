// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/shape_function.hpp>
#include <mpm/shapes/modes.hpp>

namespace mpm {
namespace shapes {

/// Cubic B-spline at `xi` cells from the origin: the nodes of its cell and one more on either side.
template <class Scalar>
AxisStencil<Scalar, 4> cubic_axis(Scalar xi, int cells) {
  const int cell = std::min(int(xi), cells - 1);
  const Scalar f = xi - Scalar(cell), g = 1 - f, sixth = Scalar(1) / 6;
  const Scalar below = g * g * g * sixth, above = f * f * f * sixth;
  return {cell - 1,
          {below, 4 * sixth - f * f + 3 * above, 4 * sixth - g * g + 3 * below, above},
          {-g * g / 2, f * (Scalar(1.5) * f - 2), g * (2 - Scalar(1.5) * g), f * f / 2}};
}

/// Replaces the node that lies beyond a face by the linear continuation of the two within, v_-1 = 2 v_0 - v_1: unity
/// and linear fields are then reproduced up to the face, and the field there is that of the node on it. The node beyond
/// keeps its place in the stencil with no weight.
template <class Scalar, int Size>
void continue_linearly(AxisStencil<Scalar, Size>& a, int cells) {
  const auto fold = [&](int beyond, int first, int second) {
    for (auto* values : {&a.w, &a.dw}) {
      auto& v = *values;
      v[first] += 2 * v[beyond];
      v[second] -= v[beyond];
      v[beyond] = 0;
    }
  };
  if (a.first < 0) fold(0, 1, 2);
  if (a.first + Size - 1 > cells) fold(Size - 1, Size - 2, Size - 3);
}

}  // namespace shapes

/// B-splines of the grid at the particle's position (Steffen, Kirby & Berzins 2008), of degree 2 or 3: gradients are
/// continuous, so nothing jumps where a particle crosses into the next cell, and there is no domain to keep.
///
/// Particles are the quadrature points: gaps open when a body is stretched, and the cubic wants four particles a cell
/// edge. Within half a cell of a face the quadratic is the hat.
template <int Degree>
struct Bspline {
  static_assert(Degree == 2 || Degree == 3, "mpm::Bspline is quadratic or cubic");

  static constexpr DomainMotion domain_motion = DomainMotion::rigid;
  template <class S>
  static constexpr int max_nodes = shapes::power(Degree + 1, S::dimension);
  template <class S>
  static constexpr std::size_t bytes = 0;

  template <class Body, class S, class Out>
  void stencil(const Body& body, std::size_t p, const Grid<S>& grid, Out& out) const {
    std::array<AxisStencil<typename S::Scalar, Degree + 1>, S::dimension> axis;
    for (int d = 0; d < S::dimension; ++d) {
      axis[d] = interior(grid.coordinate(body.x(d)[p], d), grid.cells(d));
      shapes::continue_linearly(axis[d], grid.cells(d));
    }
    shapes::tensor_product(axis, grid, out);
  }
  static constexpr int axis_nodes = Degree + 1;
  static constexpr bool continues_linearly = true;
  template <class Body, class V, std::size_t D>
  [[gnu::always_inline]] bool modes(const Body&, std::size_t, const Grid<typename Body::SpaceType>& grid,
                                    const std::array<V, D>& xi, std::array<AxisModes<V, Degree + 1>, D>& out) const {
    for (std::size_t d = 0; d < D; ++d) {
      if constexpr (Degree == 2) {
        shapes::gimp_modes(xi[d], V(0.5), out[d]);
      } else {
        shapes::cubic_modes(xi[d], grid.cells(int(d)), out[d]);
      }
    }
    return cells_suffice(grid);
  }
  /// Half the width of the box (or hat) that, averaged over, makes the spline of the hat.
  template <class Body>
  auto reach(const Body&, std::size_t, const Grid<typename Body::SpaceType>& grid) const {
    std::array<typename Body::Scalar, Body::dimension> r;
    r.fill(grid.cell() * (Degree - 1) / 2);
    return r;
  }
  void permute(std::span<const std::uint32_t>) {}

 private:
  /// A stencil of four nodes that passes both faces of an axis of one cell is not for modes.
  template <class S>
  static bool cells_suffice(const Grid<S>& grid) {
    bool enough = true;
    for (int d = 0; d < S::dimension; ++d) enough = enough && (Degree == 2 || grid.cells(d) > 1);
    return enough;
  }
  template <class Scalar>
  static AxisStencil<Scalar, Degree + 1> interior(Scalar xi, [[maybe_unused]] int cells) {
    if constexpr (Degree == 2) {
      return shapes::gimp_axis(xi, Scalar(0.5));  // the hat averaged over a box of one cell
    } else {
      return shapes::cubic_axis(xi, cells);
    }
  }
};

using QuadraticBspline = Bspline<2>;
using CubicBspline = Bspline<3>;

static_assert(ShapeFunction<QuadraticBspline> && ShapeFunction<CubicBspline>);

}  // namespace mpm
