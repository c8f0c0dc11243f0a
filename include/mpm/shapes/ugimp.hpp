// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/shape_function.hpp>
#include <mpm/shapes/modes.hpp>

namespace mpm {

/// Uniform GIMP: the hat averaged over a box that keeps its size (Bardenhagen & Kober 2004). Robust under any
/// distortion, hence the choice for gases; gaps open when a solid is stretched.
struct Ugimp {
  std::array<double, 3> half_size{};  ///< half edges of every particle's box, m; positive and at most half a cell

  static constexpr DomainMotion domain_motion = DomainMotion::rigid;
  template <class S>
  static constexpr int max_nodes = shapes::power(3, S::dimension);
  template <class S>
  static constexpr std::size_t bytes = 0;

  template <class Body, class S, class Out>
  void stencil(const Body& body, std::size_t p, const Grid<S>& grid, Out& out) const {
    using Scalar = typename S::Scalar;
    std::array<AxisStencil<Scalar, 3>, S::dimension> axis;
    for (int d = 0; d < S::dimension; ++d)
      axis[d] = shapes::gimp_axis(grid.coordinate(body.x(d)[p], d), Scalar(half_size[d]) * grid.inverse_cell());
    shapes::tensor_product(axis, grid, out);
  }
  template <class Body>
  auto reach(const Body&, std::size_t, const Grid<typename Body::SpaceType>&) const {
    std::array<typename Body::Scalar, Body::dimension> r;
    for (int d = 0; d < Body::dimension; ++d) r[d] = typename Body::Scalar(half_size[d]);
    return r;
  }
  static constexpr int axis_nodes = 3;
  template <class Body, class V, std::size_t D>
  [[gnu::always_inline]] bool modes(const Body&, std::size_t, const Grid<typename Body::SpaceType>& grid,
                                    const std::array<V, D>& xi, std::array<AxisModes<V, 3>, D>& out) const {
    for (std::size_t d = 0; d < D; ++d)
      shapes::gimp_modes(xi[d], V(half_size[d] * double(grid.inverse_cell())), out[d]);
    return true;
  }
  template <class Body, class S>
  void check(const Body& body, const Grid<S>& grid) const {
    shapes::require_half_size(body, half_size, 0.5 * (1 + 1e-6) * double(grid.cell()));
  }
  void permute(std::span<const std::uint32_t>) {}
};

static_assert(ShapeFunction<Ugimp>);

}  // namespace mpm
