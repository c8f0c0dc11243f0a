// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/shape_function.hpp>
#include <mpm/shapes/modes.hpp>
#include <limits>

namespace mpm {

/// Right stretch U of F = R U along the axes of the space: its diagonal. U, not F_ii, since a rotation must not change
/// the size of a domain (at 90 degrees F_ii vanishes).
template <int Dimension, class Scalar>
std::array<Scalar, Dimension> axis_stretch(const Tensor<Scalar>& F) {
  if constexpr (Dimension == 1) {
    return {F.xx};
  } else if constexpr (Dimension == 2) {
    // U = (C + J 1) / sqrt(tr C + 2 J), C = F^T F of the plane.
    const Scalar J = F.xx * F.yy - F.xy * F.yx;
    const Scalar Cxx = F.xx * F.xx + F.yx * F.yx, Cyy = F.xy * F.xy + F.yy * F.yy;
    const Scalar scale = Scalar(1) / sqrt(Cxx + Cyy + Scalar(2) * J);
    return {(Cxx + J) * scale, (Cyy + J) * scale};
  } else {
    // Newton's iteration for the polar decomposition (Higham 1986): R <- (R + R^-T) / 2.
    Tensor<Scalar> R = F;
    for (int k = 0; k < 8; ++k) {
      const Tensor<Scalar> cofactor{R.yy * R.zz - R.yz * R.zy, R.yz * R.zx - R.yx * R.zz, R.yx * R.zy - R.yy * R.zx,
                                    R.xz * R.zy - R.xy * R.zz, R.xx * R.zz - R.xz * R.zx, R.xy * R.zx - R.xx * R.zy,
                                    R.xy * R.yz - R.xz * R.yy, R.xz * R.yx - R.xx * R.yz, R.xx * R.yy - R.xy * R.yx};
      R = Scalar(0.5) * (R + (Scalar(1) / determinant(R)) * cofactor);
    }
    const Tensor<Scalar> U = transpose(R) * F;
    return {U.xx, U.yy, U.zz};
  }
}

/// Contiguous-particle GIMP: the box stretches with the particle (Wallstedt & Guilkey 2008). Half sizes beyond one and
/// a half cells are held there; such a particle spans four cells.
struct Cpgimp {
  std::array<double, 3> half_size{};  ///< initial half edges of every particle's box, m

  static constexpr DomainMotion domain_motion = DomainMotion::deformation_gradient;
  template <class S>
  static constexpr int max_nodes = shapes::power(5, S::dimension);
  template <class S>
  static constexpr std::size_t bytes = 0;

  template <class Body, class S, class Out>
  void stencil(const Body& body, std::size_t p, const Grid<S>& grid, Out& out) const {
    using Scalar = typename S::Scalar;
    const auto r = reach(body, p, grid);
    std::array<WideAxisStencil<Scalar, 5>, S::dimension> axis;
    for (int d = 0; d < S::dimension; ++d) {
      const Scalar l = std::min(r[d] * grid.inverse_cell(), Scalar(1.5));
      axis[d] = shapes::wide_gimp_axis<5>(grid.coordinate(body.x(d)[p], d), l);
    }
    shapes::tensor_product(axis, grid, out);
  }
  template <class Body>
  auto reach(const Body& body, std::size_t p, const Grid<typename Body::SpaceType>&) const {
    auto r = axis_stretch<Body::dimension>(body.F(p));
    for (int d = 0; d < Body::dimension; ++d) r[d] *= typename Body::Scalar(half_size[d]);
    return r;
  }
  static constexpr int axis_nodes = 3;
  /// Boxes wider than a cell span more than three nodes.
  template <class Body, class V, std::size_t D>
  [[gnu::always_inline]] bool modes(const Body& body, std::size_t p, const Grid<typename Body::SpaceType>& grid,
                                    const std::array<V, D>& xi, std::array<AxisModes<V, 3>, D>& out) const {
    const auto stretch = axis_stretch<int(D)>(body.template F<V>(p));
    bool narrow = true;
    for (std::size_t d = 0; d < D; ++d) {
      const V l = stretch[d] * V(half_size[d] * double(grid.inverse_cell()));
      narrow = narrow && !any(l > V(0.5));
      shapes::gimp_modes(xi[d], l, out[d]);
    }
    return narrow;
  }
  template <class Body, class S>
  void check(const Body& body, const Grid<S>&) const {
    shapes::require_half_size(body, half_size, std::numeric_limits<double>::infinity());
  }
  void permute(std::span<const std::uint32_t>) {}
};

static_assert(ShapeFunction<Cpgimp>);

}  // namespace mpm
