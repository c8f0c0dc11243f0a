// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body.hpp>
#include <mpm/error.hpp>
#include <mpm/shapes/cpdi_quad.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Particles of a square block with a round hole: quadrilaterals for the block, a square lattice for what fills the
// hole.
namespace mpm::geometry {

using Point = CpdiQuad::Point;

/// How much of a scene is modelled.
enum class Model {
  full,
  quarter  ///< x >= 0, y >= 0, rollers on both axes; hole and block are centred at the origin
};

/// Conforming quadrilaterals: neighbours share their corners.
struct QuadMesh {
  std::vector<Point> corner;         ///< m
  std::vector<CpdiQuad::Quad> quad;  ///< counter-clockwise
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      wall;  ///< edges round the hole, the body on their left: CpdiQuad::surface
};

/// A square block, centred at the origin, with a round hole.
///
/// Around the hole lies an O-grid: straight rays from equal arcs of the circle to a square of half side 2 radii,
/// nearly, so that the wall is made of particle edges and not of steps. Outside it are squares of `particle_size`,
/// changed as little as fills the block exactly; beside a hole off the centre they are rectangles, each side of the
/// square having its own spacing. No edge is longer than one of those, and those on the wall are about .4 of it;
/// angles lie between 45 and 135 degrees, the smallest area is about .2 of a square's.
struct HoledBlock {
  double radius = 0.021;        ///< of the hole, m
  Point centre{};               ///< of the hole, m; anywhere in a full model, the origin in a quarter
  double half_side = 0.42;      ///< of the block, m
  double particle_size = 5e-3;  ///< edge of the squares, m
  Model model = Model::quarter;

  /// Throws Error where sizes are not positive, a quarter's hole is off the origin, or the hole comes so near to the
  /// block's edge that the O-grid does not fit.
  QuadMesh mesh() const;
};

namespace detail {

/// Builds the mesh of a HoledBlock: first the rings of the O-grid, then the cells outside, which take the corners of
/// its last ring.
class HoledBlockMesher {
 public:
  explicit HoledBlockMesher(const HoledBlock& block) : block_(block), full_(block.model == Model::full) {
    check(block.radius > 0 && block.particle_size > 0 && std::isfinite(block.radius / block.particle_size),
          "radius and particle size must be positive");
    check(block.half_side > block.radius, "the half side must exceed the hole's radius");
    check(full_ || block.centre == Point{}, "the hole of a quarter model must be at the origin; take the full model");
    const double intervals = std::max(1.0, std::round(block.half_side / block.particle_size));
    edge_ = block.half_side / intervals;
    core_ = std::max(1, int(std::lround(2 * block.radius / edge_)));
    rings_ = int(std::ceil((std::numbers::sqrt2 * core_ * edge_ - block.radius) / edge_ - 1e-9));
    rays_ = full_ ? 8 * core_ : 2 * core_ + 1;
    for (int d = 0; d < 2; ++d) line_[d] = lines(block.centre[d], first_[d]);
  }

  QuadMesh build() {
    add_rings();
    add_outside();
    return std::move(mesh_);
  }

 private:
  void check(bool holds, const std::string& what) const {
    if (!holds) throw Error("HoledBlock: " + what);
  }

  /// Grid lines along one axis: the O-grid's square in steps of `edge_`, what is left on either side in equal steps
  /// nearest to it. `first` is the index of the line where the square begins.
  std::vector<double> lines(double centre, int& first) const {
    const double half = core_ * edge_, low = centre - half, high = centre + half;
    const double margin = block_.half_side * (1 + 1e-12);
    check(high <= margin && (!full_ || low >= -margin),
          "the hole needs " + std::to_string(half) + " m from its centre to each edge of the block; enlarge half_side");
    std::vector<double> x;
    if (full_) append(x, -block_.half_side, low);
    first = full_ ? int(x.size()) : 0;
    for (int i = full_ ? -core_ : 0; i < core_; ++i) x.push_back(centre + i * edge_);
    append(x, high, block_.half_side);
    x.push_back(block_.half_side);
    return x;
  }
  /// Equal steps from `from` up to, but without, `to`.
  void append(std::vector<double>& x, double from, double to) const {
    if (to - from < 1e-9 * edge_) return;
    const int steps = std::max(1, int(std::lround((to - from) / edge_)));
    for (int i = 0; i < steps; ++i) x.push_back(from + (to - from) * i / steps);
  }

  /// Where ray j meets the square, in edges from the centre. Ray 0 points along x; they go round counter-clockwise.
  std::array<int, 2> on_square(int j) const {
    const int n = core_, side = (j + n) / (2 * n) % 4, along = (j + n) % (2 * n) - n;
    switch (side) {
      case 0:
        return {n, along};
      case 1:
        return {-along, n};
      case 2:
        return {-n, -along};
      default:
        return {along, -n};
    }
  }
  std::uint32_t ring_corner(int ring, int ray) const { return std::uint32_t(ring * rays_ + ray % rays_); }

  void add_rings() {
    for (int k = 0; k <= rings_; ++k) {
      const double t = double(k) / rings_;
      for (int j = 0; j < rays_; ++j) {
        const double theta = j * std::numbers::pi / (4 * core_);
        // The quarter's rays end on the axes exactly.
        const Point unit{full_ || j < rays_ - 1 ? std::cos(theta) : 0, std::sin(theta)};
        Point x;
        for (int d = 0; d < 2; ++d)
          x[d] = block_.centre[d] + (1 - t) * block_.radius * unit[d] + t * edge_ * on_square(j)[d];
        mesh_.corner.push_back(x);
      }
    }
    const int sectors = full_ ? rays_ : rays_ - 1;
    for (int k = 0; k < rings_; ++k)
      for (int j = 0; j < sectors; ++j)
        mesh_.quad.push_back(
            {ring_corner(k, j), ring_corner(k + 1, j), ring_corner(k + 1, j + 1), ring_corner(k, j + 1)});
    for (int j = 0; j < sectors; ++j) mesh_.wall.emplace_back(ring_corner(0, j + 1), ring_corner(0, j));
  }

  void add_outside() {
    const int nx = int(line_[0].size()), ny = int(line_[1].size()), width = full_ ? 2 * core_ : core_;
    std::vector<std::uint32_t> index(std::size_t(nx) * std::size_t(ny), none);
    const auto at = [&](int i, int j) -> std::uint32_t& { return index[std::size_t(j) * std::size_t(nx) + i]; };
    const int centre = full_ ? core_ : 0;  // of the square, in lines from its first one
    for (int j = 0; j < rays_; ++j) {
      const auto [i0, i1] = on_square(j);
      at(first_[0] + centre + i0, first_[1] + centre + i1) = ring_corner(rings_, j);
    }
    const auto corner = [&](int i, int j) {
      if (at(i, j) == none) {
        at(i, j) = std::uint32_t(mesh_.corner.size());
        mesh_.corner.push_back({line_[0][i], line_[1][j]});
      }
      return at(i, j);
    };
    const auto inside = [&](int i, int d) { return i >= first_[d] && i < first_[d] + width; };
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i)
        if (!(inside(i, 0) && inside(j, 1)))
          mesh_.quad.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  }

  static constexpr std::uint32_t none = 0xffffffff;
  const HoledBlock& block_;
  bool full_;
  double edge_ = 0;                      ///< of the squares, m
  int core_ = 0, rings_ = 0, rays_ = 0;  ///< edges on half a side of the O-grid's square; rings; rays
  std::array<int, 2> first_{};           ///< line where the square begins
  std::array<std::vector<double>, 2> line_;
  QuadMesh mesh_;
};

}  // namespace detail

inline QuadMesh HoledBlock::mesh() const {
  return detail::HoledBlockMesher(*this).build();
}

/// A body at rest, one particle a quadrilateral, in its law's initial state; the wall becomes the surface under
/// CpdiQuad::pressure. `relative_volume(Point)` gives the J of the particle there.
template <class Space = PlaneStrain<>, class Law, class RelativeVolume>
Body<CpdiQuad, Law, Space> make_body(const std::string& name, const QuadMesh& mesh, const Law& law,
                                     const RelativeVolume& relative_volume) {
  Body<CpdiQuad, Law, Space> body(name, {}, law);
  body.shape.corner = mesh.corner;
  body.shape.surface = mesh.wall;
  for (const auto& quad : mesh.quad) {
    add_quad(body, quad);
    const std::size_t p = body.size() - 1;
    const auto J = relative_volume(Point{double(body.x(0)[p]), double(body.x(1)[p])});
    body.mass()[p] /= typename Space::Scalar(J);
  }
  return body;
}
template <class Space = PlaneStrain<>, class Law>
Body<CpdiQuad, Law, Space> make_body(const std::string& name, const QuadMesh& mesh, const Law& law) {
  return make_body<Space>(name, mesh, law, [](const Point&) { return 1.0; });
}

}  // namespace mpm::geometry
