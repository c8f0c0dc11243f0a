// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/shape_function.hpp>
#include <mpm/shapes/tensor_product.hpp>
#include <limits>

namespace mpm {

/// CPDI, the parallelogram of Sadeghirad, Brannon & Burghardt (2011), "R4": half edges r_k = F r_k0, the grid's hats
/// interpolated between the four corners. In one dimension a segment.
struct Cpdi {
  std::array<double, 3> half_size{};  ///< initial half edges of every particle's domain, m

  static constexpr DomainMotion domain_motion = DomainMotion::deformation_gradient;
  template <class S>
  static constexpr int max_nodes = S::dimension == 1 ? 4 : 16;
  template <class S>
  static constexpr std::size_t bytes = 0;

  template <class Body, class S, class Out>
  void stencil(const Body& body, std::size_t p, const Grid<S>& grid, Out& out) const {
    using Scalar = typename S::Scalar;
    static_assert(S::dimension < 3, "mpm::Cpdi is for one and two dimensions; take mpm::Cpgimp in three");
    const auto F = body.F(p);
    if constexpr (S::dimension == 1) {
      const Scalar r = F.xx * Scalar(half_size[0]);
      corner(grid, {body.x(0)[p] - r}, Scalar(0.5), {-1 / (2 * r)}, out);
      corner(grid, {body.x(0)[p] + r}, Scalar(0.5), {1 / (2 * r)}, out);
    } else {
      const Scalar l0 = Scalar(half_size[0]), l1 = Scalar(half_size[1]), x = body.x(0)[p], y = body.x(1)[p];
      const Scalar ax = F.xx * l0, ay = F.yx * l0, bx = F.xy * l1, by = F.yy * l1;
      const Scalar scale = 1 / (4 * (ax * by - ay * bx)), quarter = Scalar(0.25);
      const std::array<Scalar, 2> g1{(ay - by) * scale, (bx - ax) * scale}, g2{(ay + by) * scale, -(ax + bx) * scale};
      corner(grid, {x - ax - bx, y - ay - by}, quarter, g1, out);
      corner(grid, {x + ax - bx, y + ay - by}, quarter, g2, out);
      corner(grid, {x + ax + bx, y + ay + by}, quarter, {-g1[0], -g1[1]}, out);
      corner(grid, {x - ax + bx, y - ay + by}, quarter, {-g2[0], -g2[1]}, out);
    }
  }
  template <class Body>
  auto reach(const Body& body, std::size_t p) const {
    using Scalar = typename Body::Scalar;
    const auto F = body.F(p);
    const Scalar l0 = Scalar(half_size[0]);
    if constexpr (Body::dimension == 1) {
      return std::array<Scalar, 1>{F.xx * l0};
    } else {
      const Scalar l1 = Scalar(half_size[1]);
      return std::array<Scalar, 2>{std::abs(F.xx) * l0 + std::abs(F.xy) * l1,
                                   std::abs(F.yx) * l0 + std::abs(F.yy) * l1};
    }
  }
  template <class Body, class S>
  void check(const Body& body, const Grid<S>&) const {
    shapes::require_half_size(body, half_size, std::numeric_limits<double>::infinity());
  }
  void permute(std::span<const std::uint32_t>) {}

  /// Adds the nodes around one corner: weight w N_I and gradient g N_I.
  template <class S, class Out>
  static void corner(const Grid<S>& grid, const std::array<typename S::Scalar, S::dimension>& x, typename S::Scalar w,
                     const std::array<typename S::Scalar, S::dimension>& g, Out& out) {
    const auto a = shapes::hat_axis(grid.coordinate(x[0], 0), grid.cells(0));
    if constexpr (S::dimension == 1) {
      for (int i = 0; i < 2; ++i) out.add(a.first + i, w * a.w[i], {g[0] * a.w[i]});
    } else {
      const auto b = shapes::hat_axis(grid.coordinate(x[1], 1), grid.cells(1));
      const int node = a.first + b.first * grid.stride(1);
      for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
          const auto N = a.w[i] * b.w[j];
          out.add(node + i + j * grid.stride(1), w * N, {g[0] * N, g[1] * N});
        }
    }
  }
};

static_assert(ShapeFunction<Cpdi>);

}  // namespace mpm
