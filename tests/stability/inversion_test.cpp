// SPDX-License-Identifier: MIT
#include <mpm/mpm.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

// Domains under large shear and rotation.
namespace {

using namespace mpm;
using S = PlaneStrain<>;
constexpr double half = .25;  // of the particle's edge, in cells

/// A body of one particle in the middle of a grid of 40 x 40 cells, deformed by F.
template <class Shape>
Body<Shape, Hypoelastic> particle(const Tensor<double>& F) {
  Body<Shape, Hypoelastic> body{"particle", {{half, half}}, {}};
  body.add(Vector<S>{20.3, 20.1}, 4 * half * half, Vector<S>{0, 0});
  body.store_F(0, F);
  return body;
}
Grid<S> grid() {
  return {{0, 0}, 1, {40, 40}};
}
/// Largest distance of sum w from 1, sum x w from x_p and sum x (x) grad w from the identity; infinite if one is no
/// number or a weight is negative.
template <class Shape>
double defect(const Tensor<double>& F) {
  const auto body = particle<Shape>(F);
  const auto background = grid();
  double unity = -1, xx = -1, yy = -1, xy = 0, yx = 0;
  Vector<S> x = -body.position(0);
  for (const auto& [I, w, g] : make_stencil(body, 0, background)) {
    const Vector<S> at = background.position(I);
    unity += w, x += w * at;
    xx += at[0] * g[0], yy += at[1] * g[1], xy += at[0] * g[1], yx += at[1] * g[0];
    if (!(w > -1e-15)) return std::numeric_limits<double>::infinity();
  }
  double worst = 0;
  for (const double d : {unity, x[0], x[1], xx, yy, xy, yx})
    worst = std::isfinite(d) ? std::max(worst, std::abs(d)) : std::numeric_limits<double>::infinity();
  return worst;
}
Tensor<double> rotation(double degrees) {
  const double a = degrees * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
  return {c, -s, 0, s, c, 0, 0, 0, 1};
}

TEST(Inversion, ParallelogramsStandAnyShearAndSpin) {
  for (double shear = 0; shear <= 10; shear += .25) EXPECT_LT(defect<Cpdi>({1, shear, 0, 0, 1, 0, 0, 0, 1}), 1e-12);
  for (double angle = 0; angle <= 720; angle += 7.5) EXPECT_LT(defect<Cpdi>(rotation(angle)), 1e-12) << angle;
}

// With F_ii for U the box would vanish at 90 degrees and turn inside out beyond.
TEST(Inversion, BoxesKeepTheirSizeWhenTurned) {
  const auto background = grid();
  for (double angle = 0; angle <= 720; angle += 7.5) {
    const auto body = particle<Cpgimp>(rotation(angle));
    for (const double reach : body.shape.reach(body, 0, background)) EXPECT_NEAR(reach, half, 1e-14) << angle;
    EXPECT_LT(defect<Cpgimp>(rotation(angle)), 1e-12) << angle;
  }
  for (double shear = 0; shear <= 10; shear += .25) EXPECT_LT(defect<Cpgimp>({1, shear, 0, 0, 1, 0, 0, 0, 1}), 1e-12);
}

/// A quadrilateral of one cell whose upper right corner moves towards the opposite one by `share` of the diagonal;
/// returns the first particle that has inverted.
std::size_t inverted(double share) {
  Body<CpdiQuad, Hypoelastic> body{"particle", {}, {}};
  fill(body, {19, 19}, {20, 20}, 1);
  std::vector<Vector<S>> velocity(4, Vector<S>::Zero());
  for (std::size_t c = 0; c < 4; ++c)
    if (body.shape.corner[c][0] > 19.5 && body.shape.corner[c][1] > 19.5) velocity[c] = Vector<S>{-share, -share};
  return body.shape.convect(body, velocity, 1., ChunkList(4), ChunkList(1));
}

// Where the diagonals cross no more, weights turn negative; past the other diagonal there is no area. A parallelogram
// has no corner to lose.
TEST(Inversion, ACornerPastTheDiagonalIsCaught) {
  for (const double share : {0., .25, .45}) EXPECT_EQ(inverted(share), 1) << share;
  for (const double share : {1.01, 1.5}) EXPECT_EQ(inverted(share), 0) << share;
}

/// What the solver says of a closed box of dust, every particle on its own way, or nothing.
template <class Shape>
std::string said() {
  Body<Shape, Hypoelastic> dust{"dust", {}, {.density = 2000, .young = 1, .poisson = .2}};
  fill(dust, {0, 0}, {1, 1}, .05);
  for (std::size_t p = 0; p < dust.size(); ++p)
    dust.v(0)[p] = std::sin(7. * double(p)), dust.v(1)[p] = std::cos(5. * double(p));
  Solver<Shape, Hypoelastic, Usl> solver{Grid<S>{{0, 0}, .1, {10, 10}}, std::move(dust)};
  for (const int axis : {0, 1})
    for (const int side : {0, 1}) solver.boundary.face(axis, side) = Rollers<S>{};
  try {
    for (int k = 0; k < 300; ++k) solver.step();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}
TEST(Inversion, DustTurnsQuadrilateralsInsideOut) {
  EXPECT_NE(said<CpdiQuad>().find("domain turned inside out"), std::string::npos);
  EXPECT_EQ(said<Ugimp>().find("inside out"), std::string::npos);
  EXPECT_EQ(said<Cpdi>().find("inside out"), std::string::npos);
}

}  // namespace
