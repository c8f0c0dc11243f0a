// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mpm/geometry/annulus.hpp>
#include <mpm/materials/hypoelastic.hpp>
#include <algorithm>
#include <cmath>
#include <set>

namespace mpm::geometry {
namespace {

/// Quadrilaterals that fill the polygons between the circles, and meet edge to edge.
void expect_a_ring(const Annulus& ring, double share_of_circle) {
  const QuadMesh mesh = ring.mesh();
  const auto body = make_body("ring", mesh, Hypoelastic{});
  double area = 0, smallest = 1, largest = 0;
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t p = 0; p < body.size(); ++p) {
    area += body.volume()[p];
    smallest = std::min(smallest, body.volume()[p]), largest = std::max(largest, body.volume()[p]);
    for (int c = 0; c < 4; ++c) edges.insert({mesh.quad[p][c], mesh.quad[p][(c + 1) % 4]});
  }
  const double size = ring.particle_size, pi = std::numbers::pi;
  const double exact = share_of_circle * pi * (ring.outer * ring.outer - ring.inner * ring.inner);
  EXPECT_NEAR(area, exact * (1 - std::pow(size / (ring.inner + ring.outer) * 2, 2) / 6), 1e-4 * exact);
  EXPECT_GT(smallest, 0.7 * size * size);
  EXPECT_LT(largest, 1.3 * size * size);
  double wall = 0;
  for (const auto& [i, j] : mesh.wall) {
    EXPECT_NEAR(std::hypot(mesh.corner[i][0], mesh.corner[i][1]), ring.inner, 1e-14);
    wall += std::hypot(mesh.corner[j][0] - mesh.corner[i][0], mesh.corner[j][1] - mesh.corner[i][1]);
    EXPECT_EQ(edges.count({i, j}), 1u);  // as a quadrilateral has it: the body on its left
  }
  EXPECT_NEAR(wall, share_of_circle * 2 * pi * ring.inner, 1e-3 * wall);
  int free = 0;
  for (const auto& [i, j] : edges) {
    EXPECT_EQ(edges.count({i, j}), 1u);
    free += edges.count({j, i}) == 0;
  }
  const int rings = int(std::lround((ring.outer - ring.inner) / size));
  EXPECT_EQ(free, 2 * int(mesh.wall.size()) + (ring.model == Model::quarter ? 2 * rings : 0));
}
TEST(Annulus, IsARingOfQuadrilaterals) {
  expect_a_ring({.inner = 0.75, .outer = 1.25, .particle_size = 0.05}, 1);
  expect_a_ring({.inner = 0.4, .outer = 0.6, .particle_size = 0.02, .model = Model::quarter}, 0.25);
}
TEST(Annulus, AQuarterEndsOnTheAxes) {
  const QuadMesh mesh = Annulus{.inner = 1, .outer = 2, .particle_size = 0.1, .model = Model::quarter}.mesh();
  for (int d : {0, 1}) EXPECT_EQ(std::ranges::count_if(mesh.corner, [&](const Point& x) { return x[d] == 0; }), 11);
  for (const Point& x : mesh.corner) EXPECT_GE(std::min(x[0], x[1]), 0);
}
TEST(Annulus, RefusesWhatIsNone) {
  EXPECT_THROW((Annulus{.inner = 0}.mesh()), Error);
  EXPECT_THROW((Annulus{.inner = 2, .outer = 1}.mesh()), Error);
  EXPECT_THROW((Annulus{.particle_size = 0}.mesh()), Error);
}

}  // namespace
}  // namespace mpm::geometry
