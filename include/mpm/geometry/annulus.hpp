// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/error.hpp>
#include <mpm/geometry/holed_block.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace mpm::geometry {

/// A ring about the origin, in quadrilaterals on a polar mesh whose corners lie on the circles and rays.
struct Annulus {
  double inner = 1, outer = 2;  ///< radii, m
  double particle_size = 0.1;   ///< edge of a quadrilateral at the mean radius, nearly, m
  Model model = Model::full;

  /// Throws Error unless 0 < inner < outer and the particle size is positive.
  QuadMesh mesh() const {
    if (!(inner > 0 && outer > inner && particle_size > 0))
      throw Error("Annulus: the radii must be positive, the outer the larger, and the particle size positive");
    const bool full = model == Model::full;
    const double angle = full ? 2 * std::numbers::pi : std::numbers::pi / 2;
    const int rings = std::max(1, int(std::lround((outer - inner) / particle_size)));
    const int sectors = std::max(full ? 3 : 1, int(std::lround(angle * (inner + outer) / 2 / particle_size)));
    const int rays = full ? sectors : sectors + 1;
    QuadMesh mesh;
    for (int k = 0; k <= rings; ++k)
      for (int j = 0; j < rays; ++j) {
        const double r = inner + (outer - inner) * k / rings, theta = angle * j / sectors;
        // A quarter's last ray is the y axis exactly.
        mesh.corner.push_back({!full && j == sectors ? 0 : r * std::cos(theta), r * std::sin(theta)});
      }
    const auto corner = [&](int k, int j) { return std::uint32_t(k * rays + j % rays); };
    for (int k = 0; k < rings; ++k)
      for (int j = 0; j < sectors; ++j)
        mesh.quad.push_back({corner(k, j), corner(k + 1, j), corner(k + 1, j + 1), corner(k, j + 1)});
    for (int j = 0; j < sectors; ++j) mesh.wall.emplace_back(corner(0, j + 1), corner(0, j));
    return mesh;
  }
};

}  // namespace mpm::geometry
