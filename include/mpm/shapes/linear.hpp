// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/shape_function.hpp>
#include <mpm/shapes/modes.hpp>

namespace mpm {

/// Linear shape functions of the grid at the particle's position: the original material point method (Sulsky, Chen &
/// Schreyer 1994). Gradients jump where a particle crosses into the next cell.
struct Linear {
  static constexpr DomainMotion domain_motion = DomainMotion::rigid;
  template <class S>
  static constexpr int max_nodes = shapes::power(2, S::dimension);
  template <class S>
  static constexpr std::size_t bytes = 0;

  template <class Body, class S, class Out>
  void stencil(const Body& body, std::size_t p, const Grid<S>& grid, Out& out) const {
    std::array<AxisStencil<typename S::Scalar, 2>, S::dimension> axis;
    for (int d = 0; d < S::dimension; ++d) axis[d] = shapes::hat_axis(grid.coordinate(body.x(d)[p], d), grid.cells(d));
    shapes::tensor_product(axis, grid, out);
  }
  template <class Body>
  auto reach(const Body&, std::size_t, const Grid<typename Body::SpaceType>&) const {
    return std::array<typename Body::Scalar, Body::dimension>{};
  }
  static constexpr int axis_nodes = 2;
  template <class Body, class V, std::size_t D>
  [[gnu::always_inline]] bool modes(const Body&, std::size_t, const Grid<typename Body::SpaceType>& grid,
                                    const std::array<V, D>& xi, std::array<AxisModes<V, 2>, D>& out) const {
    for (std::size_t d = 0; d < D; ++d) shapes::hat_modes(xi[d], grid.cells(int(d)), out[d]);
    return true;
  }
  void permute(std::span<const std::uint32_t>) {}
};

static_assert(ShapeFunction<Linear>);

}  // namespace mpm
