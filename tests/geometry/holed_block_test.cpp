// SPDX-License-Identifier: MIT
#include <mpm/geometry/holed_block.hpp>
#include <mpm/materials/hypoelastic.hpp>
#include <gtest/gtest.h>
#include <algorithm>
#include <map>
#include <numbers>
#include <string>

namespace {

using namespace mpm::geometry;

constexpr double a = 0.021;

struct Scene {
  const char* name;
  HoledBlock block;
};
/// Quarter and full models; particles that divide the block and some that do not; holes off the centre.
const Scene one_hole[] = {
    {"quarter", {.radius = a, .half_side = 20 * a, .particle_size = a / 8}},
    {"paper", {.radius = a, .half_side = .42, .particle_size = 5e-3}},
    {"uneven", {.radius = a, .half_side = .403, .particle_size = 4.7e-3}},
    {"full", {.radius = a, .half_side = 8 * a, .particle_size = a / 4, .model = Model::full}},
    {"shifted",
     {.radius = a, .centres = {{.0031, .0017}}, .half_side = .2, .particle_size = 5e-3, .model = Model::full}},
    {"far_off", {.radius = a, .centres = {{-.1, .05}}, .half_side = .2, .particle_size = 5e-3, .model = Model::full}},
};
/// In line, as near as may be, and a little out of line.
const Scene several_holes[] = {
    {"pair",
     {.radius = a, .centres = {{-.15, 0}, {.15, 0}}, .half_side = .3, .particle_size = 5e-3, .model = Model::full}},
    {"close_pair",
     {.radius = a, .centres = {{0, -3 * a}, {0, 3 * a}}, .half_side = .3, .particle_size = a, .model = Model::full}},
    {"staggered",
     {.radius = a,
      .centres = {{-.1, .002}, {.1, -.1}, {.099, .107}},
      .half_side = .3,
      .particle_size = 5e-3,
      .model = Model::full}},
};

class HoledBlockMesh : public testing::TestWithParam<Scene> {
 protected:
  const HoledBlock block = GetParam().block;
  const QuadMesh mesh = block.mesh();
  const double quarters = block.model == Model::full ? 4 : 1;
  const double whole_angle = double(block.centres.size()) * quarters * std::numbers::pi / 2;  ///< of all walls

  Point nearest_centre(const Point& x) const {
    return *std::ranges::min_element(block.centres, {},
                                     [&](const Point& c) { return std::hypot(x[0] - c[0], x[1] - c[1]); });
  }

  Point at(std::uint32_t c) const { return mesh.corner[c]; }
  static double cross(const Point& o, const Point& p, const Point& q) {
    return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
  }
  double area(const mpm::CpdiQuad::Quad& q) const {
    return (cross(at(q[0]), at(q[1]), at(q[2])) + cross(at(q[0]), at(q[2]), at(q[3]))) / 2;
  }
  bool on_face(const Point& p, const Point& q) const {
    for (int d = 0; d < 2; ++d) {
      const double lowest = block.model == Model::full ? -block.half_side : 0;
      for (double face : {lowest, block.half_side})
        if (p[d] == face && q[d] == face) return true;
    }
    return false;
  }
};
class OneHoleMesh : public HoledBlockMesh {};
const auto name = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(One, HoledBlockMesh, testing::ValuesIn(one_hole), name);
INSTANTIATE_TEST_SUITE_P(Several, HoledBlockMesh, testing::ValuesIn(several_holes), name);
INSTANTIATE_TEST_SUITE_P(One, OneHoleMesh, testing::ValuesIn(one_hole), name);

TEST_P(HoledBlockMesh, FillsTheBlockExactly) {
  double sum = 0;
  for (const auto& q : mesh.quad) {
    EXPECT_GT(area(q), 0);
    sum += area(q);
  }
  const double angle = whole_angle / double(mesh.wall.size());
  const double hole = double(mesh.wall.size()) * a * a * std::sin(angle) / 2;
  EXPECT_NEAR(sum, quarters * block.half_side * block.half_side - hole, 1e-13);
}

TEST_P(HoledBlockMesh, ConformsAndIsBoundedByWallAndFacesOnly) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& q : mesh.quad)
    for (int c = 0; c < 4; ++c) ++edges[{q[c], q[(c + 1) % 4]}];
  std::size_t wall = 0;
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << "two quadrilaterals on one side of an edge";
    if (edges.count({edge.second, edge.first})) continue;
    if (on_face(at(edge.first), at(edge.second))) continue;
    ++wall;
    EXPECT_EQ(std::count(mesh.wall.begin(), mesh.wall.end(), edge), 1) << "a hole in the mesh, or a wall turned round";
  }
  EXPECT_EQ(wall, mesh.wall.size());
}

TEST_P(HoledBlockMesh, WallsAreTheCircles) {
  double angle = 0;
  std::map<Point, double> of_hole;
  for (const auto& [i, j] : mesh.wall) {
    const Point centre = nearest_centre(at(i));
    for (auto c : {i, j}) EXPECT_NEAR(std::hypot(at(c)[0] - centre[0], at(c)[1] - centre[1]), a, 1e-15);
    angle -= std::asin(cross(centre, at(i), at(j)) / (a * a));
    of_hole[centre] = angle;
  }
  EXPECT_NEAR(angle, whole_angle, 1e-12);
  EXPECT_EQ(of_hole.size(), block.centres.size());
}

TEST_P(OneHoleMesh, KeepsShapeAndSize) {
  const double size = block.particle_size;
  std::size_t squares = 0;
  for (const auto& q : mesh.quad) {
    bool square = true;
    for (int c = 0; c < 4; ++c) {
      const Point x = at(q[c]), next = at(q[(c + 1) % 4]), last = at(q[(c + 3) % 4]);
      const double edge = std::hypot(next[0] - x[0], next[1] - x[1]),
                   other = std::hypot(last[0] - x[0], last[1] - x[1]);
      const double sine = cross(x, next, last) / (edge * other);
      EXPECT_GT(sine, std::sin(43.9 * std::numbers::pi / 180));  // all angles lie between 44 and 136 degrees
      EXPECT_LT(edge, 1.03 * size);
      EXPECT_GT(edge, .38 * size);
      square = square && std::abs(edge / size - 1) < .03 && sine > 1 - 1e-9;
    }
    squares += square;
  }
  const double grid = 2.3 * a;  // no O-grid is wider
  EXPECT_GT(double(squares) * size * size, .97 * quarters * (block.half_side * block.half_side - grid * grid));
}

// Nor beside holes out of line by a fifth of an edge and by one and two fifths.
TEST_P(HoledBlockMesh, HasNoSlivers) {
  for (const auto& q : mesh.quad)
    for (int c = 0; c < 4; ++c) {
      const Point x = at(q[c]), next = at(q[(c + 1) % 4]), last = at(q[(c + 3) % 4]);
      const double edge = std::hypot(next[0] - x[0], next[1] - x[1]),
                   other = std::hypot(last[0] - x[0], last[1] - x[1]);
      EXPECT_GT(cross(x, next, last), edge * other * std::sin(35 * std::numbers::pi / 180));
      EXPECT_GT(edge, .3 * block.particle_size);
      EXPECT_LT(edge, 1.6 * block.particle_size);
    }
}

TEST(HoledBlock, RefusesWhatHasNoMesh) {
  const auto complaint = [](const HoledBlock& block) -> std::string {
    try {
      block.mesh();
    } catch (const mpm::Error& e) {
      return e.what();
    }
    return "none";
  };
  EXPECT_NE(complaint({.radius = -a}).find("must be positive"), std::string::npos);
  EXPECT_NE(complaint({.radius = a, .half_side = .02}).find("exceed"), std::string::npos);
  EXPECT_NE(complaint({.radius = a, .half_side = .035}).find("enlarge half_side"), std::string::npos);
  EXPECT_NE(complaint({.radius = a, .centres = {{0, .01}}}).find("take the full model"), std::string::npos);
  EXPECT_NE(complaint({.radius = a, .centres = {{0, 0}, {3.9 * a, 0}}, .model = Model::full}).find("too close"),
            std::string::npos);
  EXPECT_NE(complaint({.radius = a, .centres = {{-.39, 0}}, .model = Model::full}).find("enlarge"), std::string::npos);
}

TEST(MakeBody, TakesDensityFromTheRelativeVolume) {
  const QuadMesh mesh = HoledBlock{.radius = a, .half_side = 8 * a, .particle_size = a / 2}.mesh();
  const auto J = [](const Point& x) { return 1 - x[0]; };
  const auto body = make_body("rock", mesh, mpm::Hypoelastic{.density = 2000}, J);
  ASSERT_EQ(body.size(), mesh.quad.size());
  EXPECT_EQ(body.shape.surface, mesh.wall);
  for (std::size_t p = 0; p < body.size(); ++p) {
    EXPECT_NEAR(body.relative_volume(p), 1 - body.x(0)[p], 1e-14);
    EXPECT_NEAR(body.mass()[p], 2000 * body.shape.weights(p).area / (1 - body.x(0)[p]), 1e-14);
  }
}

}  // namespace
