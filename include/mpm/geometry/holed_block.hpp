// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body.hpp>
#include <mpm/error.hpp>
#include <mpm/shapes/cpdi_quad.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Particles of a square block with round holes: quadrilaterals for the block, a square lattice for what fills a hole.
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
      wall;  ///< edges round the holes, the body on their left: CpdiQuad::surface
};

/// A square block, centred at the origin, with round holes of one size.
///
/// Around each hole lies an O-grid: straight rays from equal arcs of the circle to a square of half side 2 radii,
/// nearly, so that the wall is made of particle edges and not of steps. Outside them lies a grid of rectangles whose
/// lines run through the holes' centres: they are squares of `particle_size` where holes are far apart or in line, and
/// from half to one and a half of it beside holes that are a little out of line. With one hole no edge is longer than
/// 1.03 of it, and those on the wall are about .4 of it; angles lie between 44 and 136 degrees, the smallest area is
/// about .2 of a square's.
struct HoledBlock {
  double radius = 0.021;                ///< of the holes, m
  std::vector<Point> centres{Point{}};  ///< of the holes, m; anywhere in a full model, the origin in a quarter
  double half_side = 0.42;              ///< of the block, m
  double particle_size = 5e-3;          ///< edge of the squares, m
  Model model = Model::quarter;

  /// Throws Error where sizes are not positive, a quarter's hole is off the origin, or holes come so near to each other
  /// or to the block's edge that an O-grid does not fit.
  QuadMesh mesh() const;
};

namespace detail {

/// Builds the mesh of a HoledBlock: first the rings of the O-grids, then the cells outside, which take the corners of
/// their last rings.
class HoledBlockMesher {
 public:
  explicit HoledBlockMesher(const HoledBlock& block) : block_(block), full_(block.model == Model::full) {
    check(block.radius > 0 && block.particle_size > 0 && std::isfinite(block.radius / block.particle_size),
          "radius and particle size must be positive");
    check(block.half_side > block.radius, "the half side must exceed the hole's radius");
    check(full_ || (block.centres.size() == 1 && block.centres[0] == Point{}),
          "the hole of a quarter model must be at the origin; take the full model");
    edge_ = block.half_side / std::max(1.0, std::round(block.half_side / block.particle_size));
    core_ = std::max(1, int(std::lround(2 * block.radius / edge_)));
    rays_ = full_ ? 8 * core_ : 2 * core_ + 1;
    for (int d = 0; d < 2; ++d) line_[d] = lines(d);
    taken_.resize(line_[0].size() * line_[1].size());
    outside_.resize(taken_.size(), none);
  }

  QuadMesh build() {
    for (const Point& centre : block_.centres) add_rings(centre);
    add_outside();
    return std::move(mesh_);
  }

 private:
  void check(bool holds, const std::string& what) const {
    if (!holds) throw Error("HoledBlock: " + what);
  }
  void check_apart(bool holds) const {
    check(holds, "two holes are too close to each other; set them " + std::to_string(6 * block_.radius) +
                     " m apart along x or y");
  }

  /// Grid lines along one axis: through the holes' centres (one for those nearer than half an edge), and in equal steps
  /// nearest to `edge_` between them and to the sides of the block.
  std::vector<double> lines(int d) const {
    std::vector<double> centres, fixed{full_ ? -block_.half_side : 0};
    for (const Point& centre : block_.centres) centres.push_back(centre[d]);
    std::sort(centres.begin(), centres.end());
    for (const double x : centres)
      if (x - fixed.back() > edge_ / 2) fixed.push_back(x);
    fixed.push_back(block_.half_side);
    std::vector<double> x;
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
      const double gap = fixed[k + 1] - fixed[k];
      const int steps = std::max(1, int(std::lround(gap / edge_)));
      for (int i = 0; i < steps; ++i) x.push_back(fixed[k] + gap * i / steps);
    }
    x.push_back(block_.half_side);
    return x;
  }
  /// The line nearest to a coordinate.
  int nearest(int d, double x) const {
    const auto& line = line_[d];
    return int(std::ranges::min_element(line, {}, [&](double l) { return std::abs(l - x); }) - line.begin());
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

  /// Takes the cells of a hole's square for its O-grid.
  void take(const std::array<int, 2>& at) {
    for (int d = 0; d < 2; ++d)
      check(at[d] + core_ < int(line_[d].size()) && (!full_ || at[d] >= core_),
            "a hole needs " + std::to_string(core_ * edge_) +
                " m from its centre to each edge of the block; enlarge half_side");
    const int low = full_ ? -core_ : 0;
    for (int j = low; j < core_; ++j)
      for (int i = low; i < core_; ++i) {
        check_apart(!taken_[index(at[0] + i, at[1] + j)]);
        taken_[index(at[0] + i, at[1] + j)] = true;
      }
  }

  void add_rings(const Point& centre) {
    const std::array<int, 2> at{nearest(0, centre[0]), nearest(1, centre[1])};
    take(at);
    const auto square = [&](int j) -> Point {
      const auto [i0, i1] = on_square(j);
      return {line_[0][at[0] + i0], line_[1][at[1] + i1]};
    };
    double farthest = 0;
    for (int j = core_; j < rays_; j += 2 * core_)
      farthest = std::max(farthest, std::hypot(square(j)[0] - centre[0], square(j)[1] - centre[1]));
    const int rings = int(std::ceil((farthest - block_.radius) / edge_ - 1e-9));
    const auto first = std::uint32_t(mesh_.corner.size());
    const auto corner = [&](int ring, int ray) { return first + std::uint32_t(ring * rays_ + ray % rays_); };
    for (int k = 0; k <= rings; ++k) {
      const double t = double(k) / rings;
      for (int j = 0; j < rays_; ++j) {
        const double theta = j * std::numbers::pi / (4 * core_);
        // The quarter's rays end on the axes exactly.
        const Point unit{full_ || j < rays_ - 1 ? std::cos(theta) : 0, std::sin(theta)};
        Point x;
        for (int d = 0; d < 2; ++d) x[d] = (1 - t) * (centre[d] + block_.radius * unit[d]) + t * square(j)[d];
        mesh_.corner.push_back(x);
      }
    }
    const int sectors = full_ ? rays_ : rays_ - 1;
    for (int k = 0; k < rings; ++k)
      for (int j = 0; j < sectors; ++j)
        mesh_.quad.push_back({corner(k, j), corner(k + 1, j), corner(k + 1, j + 1), corner(k, j + 1)});
    for (int j = 0; j < sectors; ++j) mesh_.wall.emplace_back(corner(0, j + 1), corner(0, j));
    for (int j = 0; j < rays_; ++j) {
      auto& shared = outside_[index(at[0] + on_square(j)[0], at[1] + on_square(j)[1])];
      check_apart(shared == none);
      shared = corner(rings, j);
    }
  }

  void add_outside() {
    const auto corner = [&](int i, int j) {
      auto& here = outside_[index(i, j)];
      if (here == none) {
        here = std::uint32_t(mesh_.corner.size());
        mesh_.corner.push_back({line_[0][i], line_[1][j]});
      }
      return here;
    };
    for (int j = 0; j + 1 < int(line_[1].size()); ++j)
      for (int i = 0; i + 1 < int(line_[0].size()); ++i)
        if (!taken_[index(i, j)])
          mesh_.quad.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  }
  std::size_t index(int i, int j) const { return std::size_t(j) * line_[0].size() + std::size_t(i); }

  static constexpr std::uint32_t none = 0xffffffff;
  const HoledBlock& block_;
  bool full_;
  double edge_ = 0;          ///< of the squares, m
  int core_ = 0, rays_ = 0;  ///< edges on half a side of an O-grid's square
  std::array<std::vector<double>, 2> line_;
  std::vector<bool> taken_;             ///< cells of the grid that belong to an O-grid
  std::vector<std::uint32_t> outside_;  ///< corner of the mesh at each crossing of lines
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
