// SPDX-License-Identifier: MIT
// Single shapes against the printed formulas and against quadrature.
#include <gtest/gtest.h>
#include <mpm/mpm.hpp>
#include <cmath>
#include <random>

namespace {

using namespace mpm;

/// Bardenhagen & Kober's piecewise form: weight of a node at distance d from the centre of a box of half size l.
double gimp_weight(double d, double l, double h) {
  d = std::abs(d);
  if (d < l) return 1 - (d * d + l * l) / (2 * h * l);
  if (d < h - l) return 1 - d / h;
  return d < h + l ? (h + l - d) * (h + l - d) / (4 * h * l) : 0;
}

template <class Shape>
class Gimp : public ::testing::Test {};
using GimpShapes = ::testing::Types<Ugimp, Cpgimp>;
TYPED_TEST_SUITE(Gimp, GimpShapes);

TYPED_TEST(Gimp, IsThePrintedPiecewiseForm) {
  using S = Uniaxial<>;
  const double h = 0.2;
  const Grid<S> grid{Vector<S>{-1.0}, h, {12}};
  for (const double l : {0.02, 0.05, 0.1}) {
    Body<TypeParam, Hypoelastic, S> body{"particle", {{l, l, l}}, {}};
    body.add(Vector<S>{0.0}, 1, Vector<S>{0.0});
    for (double x = -0.3; x < 0.3; x += 0.0037) {
      body.x(0)[0] = x;
      std::array<double, 13> w{};
      for (const auto& [I, weight, gradient] : make_stencil(body, 0, grid)) w[I] += weight;
      for (int I = 0; I < 13; ++I) EXPECT_NEAR(w[I], gimp_weight(x - grid.position(I)[0], l, h), 1e-14) << x;
    }
  }
}

/// Of a node that the box reaches past the nearest one's by u cells the weight is u^2/4l and its gradient u/2l, one l
/// times the square of the other however small u: were either round-off, the node's acceleration would be anything.
TYPED_TEST(Gimp, ANodeBarelyTouchedHasItsShareToTheLastBit) {
  using S = Uniaxial<>;
  const Grid<S> grid{Vector<S>{0.0}, 1, {8}};
  const double l = 0.25;
  for (const double side : {-1., 1.})
    for (double u = 1e-3; u > 1e-13; u /= 10) {
      Body<TypeParam, Hypoelastic, S> body{"particle", {{l, l, l}}, {}};
      body.add(Vector<S>{4 + side * (u - l)}, 1, Vector<S>{0.0});
      const int node = side > 0 ? 5 : 3;
      double w = 0, slope = 0;
      for (const auto& [I, weight, gradient] : make_stencil(body, 0, grid))
        if (I == node) w += weight, slope += gradient[0];
      EXPECT_NEAR(w, l * slope * slope, 1e-12 * w) << u;
      EXPECT_NEAR(slope, side * u / (2 * l), 1e-14) << u;
    }
}

template <class Random>
Tensor<double> random_tensor(Random& engine, double size, bool plane) {
  std::uniform_real_distribution<> n(-size, size);
  if (plane) return {n(engine), n(engine), 0, n(engine), n(engine), 0, 0, 0, 0};
  return {n(engine), n(engine), n(engine), n(engine), n(engine), n(engine), n(engine), n(engine), n(engine)};
}

TEST(Cpgimp, ARotationDoesNotChangeTheDomain) {
  std::mt19937_64 engine{7};
  for (const bool plane : {true, false}) {
    for (int trial = 0; trial < 100; ++trial) {
      const auto a = random_tensor(engine, 0.4, plane);
      const auto U = Tensor<double>::identity() + 0.5 * (a + transpose(a));
      const auto R = step_rotation(random_tensor(engine, 10, plane), 1.0);
      if (plane) {
        const auto stretch = axis_stretch<2>(R * U);
        EXPECT_NEAR(stretch[0], U.xx, 1e-12);
        EXPECT_NEAR(stretch[1], U.yy, 1e-12);
      } else {
        const auto stretch = axis_stretch<3>(R * U);
        EXPECT_NEAR(stretch[0], U.xx, 1e-12);
        EXPECT_NEAR(stretch[1], U.yy, 1e-12);
        EXPECT_NEAR(stretch[2], U.zz, 1e-12);
      }
    }
  }
  const auto quarter_turn = axis_stretch<2>(Tensor<double>{0, -1, 0, 1, 0, 0, 0, 0, 1});
  EXPECT_DOUBLE_EQ(quarter_turn[0], 1);
  EXPECT_DOUBLE_EQ(quarter_turn[1], 1);
}

struct Quadrature {
  double area = 0;
  std::array<double, 4> w{};
  std::array<std::array<double, 2>, 4> gradient{};
};

/// Averages of the bilinear functions of a quadrilateral and of their gradients, by 3x3 Gauss points.
Quadrature integrate(const std::array<CpdiQuad::Point, 4>& x) {
  constexpr std::array<double, 4> si{-1, 1, 1, -1}, ti{-1, -1, 1, 1};
  const double g = std::sqrt(0.6);
  Quadrature q;
  for (const auto& [s, ws] : {std::pair{-g, 5. / 9}, {0., 8. / 9}, {g, 5. / 9}})
    for (const auto& [t, wt] : {std::pair{-g, 5. / 9}, {0., 8. / 9}, {g, 5. / 9}}) {
      std::array<double, 4> Ns, Nt;
      double xs = 0, xt = 0, ys = 0, yt = 0;
      for (int c = 0; c < 4; ++c) {
        Ns[c] = si[c] * (1 + ti[c] * t) / 4, Nt[c] = ti[c] * (1 + si[c] * s) / 4;
        xs += Ns[c] * x[c][0], xt += Nt[c] * x[c][0], ys += Ns[c] * x[c][1], yt += Nt[c] * x[c][1];
      }
      const double J = (xs * yt - xt * ys) * ws * wt;
      q.area += J;
      for (int c = 0; c < 4; ++c) {
        q.w[c] += J * (1 + si[c] * s) * (1 + ti[c] * t) / 4;
        q.gradient[c][0] += ws * wt * (Ns[c] * yt - Nt[c] * ys);
        q.gradient[c][1] += ws * wt * (Nt[c] * xs - Ns[c] * xt);
      }
    }
  for (int c = 0; c < 4; ++c) q.w[c] /= q.area, q.gradient[c][0] /= q.area, q.gradient[c][1] /= q.area;
  return q;
}

TEST(CpdiQuad, WeightsAreTheAveragesOverTheQuadrilateral) {
  std::mt19937_64 engine{11};
  std::uniform_real_distribution<> shift(-0.45, 0.45);
  for (int trial = 0; trial < 200; ++trial) {
    CpdiQuad shape;
    std::array<CpdiQuad::Point, 4> x{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (auto& point : x) point = {point[0] + shift(engine), point[1] + shift(engine)};
    shape.corner.assign(x.begin(), x.end());
    shape.quad = {{0, 1, 2, 3}};
    const auto got = shape.weights(0);
    const auto want = integrate(x);
    EXPECT_NEAR(got.area, want.area, 1e-14);
    for (int c = 0; c < 4; ++c) {
      EXPECT_NEAR(got.w[c], want.w[c], 1e-14);
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(got.gradient[c][d], want.gradient[c][d], 1e-14);
    }
  }
}

TEST(Cpdi, IsTheParallelogramOfCpdiQuad) {
  using S = PlaneStrain<>;
  std::mt19937_64 engine{13};
  std::uniform_real_distribution<> place(1, 2);
  const Grid<S> grid{{0, 0}, 0.25, {12, 12}};
  const double l = 0.1, k = 0.07;
  for (int trial = 0; trial < 100; ++trial) {
    const Vector<S> x{place(engine), place(engine)};
    const auto F = Tensor<double>::identity() + random_tensor(engine, 0.5, true);
    if (determinant(F) < 0.2) continue;
    Body<Cpdi, Hypoelastic, S> parallelogram{"r4", {{l, k, 0}}, {}};
    parallelogram.add(x, 1, {0, 0});
    parallelogram.store_F(0, F);
    Body<CpdiQuad, Hypoelastic, S> quad{"q4", {}, {}};
    for (const auto& [i, j] : {std::pair{-l, -k}, {l, -k}, {l, k}, {-l, k}})
      quad.shape.corner.push_back({x[0] + F.xx * i + F.xy * j, x[1] + F.yx * i + F.yy * j});
    add_quad(quad, {0, 1, 2, 3});
    std::vector<std::array<double, 3>> difference(grid.size());
    for (const auto& [I, w, g] : make_stencil(parallelogram, 0, grid))
      difference[I][0] += w, difference[I][1] += g[0], difference[I][2] += g[1];
    for (const auto& [I, w, g] : make_stencil(quad, 0, grid))
      difference[I][0] -= w, difference[I][1] -= g[0], difference[I][2] -= g[1];
    for (const auto& [w, gx, gy] : difference) {
      EXPECT_NEAR(w, 0, 1e-13);
      EXPECT_NEAR(gx, 0, 1e-11);
      EXPECT_NEAR(gy, 0, 1e-11);
    }
  }
}

}  // namespace
