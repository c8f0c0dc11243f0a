// SPDX-License-Identifier: MIT
// B-splines against the recursion that defines them, at faces, in the order of particles and in the stable step.
#include <gtest/gtest.h>
#include <mpm/mpm.hpp>
#include <cmath>
#include <random>

namespace {

using namespace mpm;
using S = Uniaxial<>;
constexpr double h = 0.2;
constexpr int cells = 12;

/// Spline of a degree on the integer knots 0 .. degree + 1 (de Boor's recursion).
double de_boor(int degree, double x) {
  if (degree == 0) return x >= 0 && x < 1;
  return (x * de_boor(degree - 1, x) + (degree + 1 - x) * de_boor(degree - 1, x - 1)) / degree;
}

template <class Shape>
struct Particle {
  Grid<S> grid{Vector<S>{-1.0}, h, {cells}};
  Body<Shape, Hypoelastic, S> body{"particle", {}, {1, 1, 0}};

  Particle() { body.add(Vector<S>{0.0}, 1, Vector<S>{0.0}); }
  /// Stencil at `xi` cells from the lower face.
  auto at(double xi) {
    body.x(0)[0] = grid.origin()[0] + xi * h;
    return make_stencil(body, 0, grid);
  }
  std::array<double, cells + 1> weights(double xi) {
    std::array<double, cells + 1> w{};
    for (const auto& [I, weight, gradient] : at(xi)) w[std::size_t(I)] += weight;
    return w;
  }
  /// The certain step at rest in units of h / c.
  double step(double xi) {
    const double c = std::sqrt(body.law.tangent(body.law.template initial<double>(), 1.).longitudinal);
    at(xi);
    return stable_step(body, ChunkList(body.size()), grid) * c / h;
  }
};

template <class Shape>
void expect_de_boor(int degree) {
  Particle<Shape> particle;
  for (double xi = 2; xi < cells - 2; xi += 0.0371) {
    const auto w = particle.weights(xi);
    for (int I = 0; I <= cells; ++I)
      EXPECT_NEAR(w[std::size_t(I)], de_boor(degree, xi - I + 0.5 * (degree + 1)), 2e-14) << xi;
  }
}
TEST(Bspline, WeightsFollowTheRecursion) {
  expect_de_boor<QuadraticBspline>(2);
  expect_de_boor<CubicBspline>(3);
}

/// The face's own node holds the field there, and what lies beyond is continued linearly.
TEST(Bspline, TheFaceIsANode) {
  Particle<QuadraticBspline> quadratic;
  Particle<CubicBspline> cubic;
  for (double f = 0; f <= 1; f += 0.0625)
    for (const bool upper : {false, true}) {
      const double xi = upper ? cells - f : f;
      const auto q = quadratic.weights(xi), c = cubic.weights(xi);
      const auto I = [&](int from_face) { return std::size_t(upper ? cells - from_face : from_face); };
      EXPECT_NEAR(q[I(0)], f < 0.5 ? 1 - f : (1.5 - f) * (1.5 - f) / 2, 1e-14) << f;
      EXPECT_NEAR(c[I(0)], 1 - f + f * f * f / 6, 1e-14) << f;
      EXPECT_NEAR(c[I(1)], f - f * f * f / 3, 1e-14) << f;
      EXPECT_NEAR(c[I(2)], f * f * f / 6, 1e-14) << f;
    }
}

template <class Shape>
std::size_t wide_particles() {
  using Plane = PlaneStrain<>;
  Grid<Plane> grid{{0, 0}, 0.1, {11, 23}};
  Body<Shape, Hypoelastic> body{"body", {}, {1000, 1e6, .3}};
  std::mt19937_64 engine{17};
  std::uniform_real_distribution<> x(0, 1.1), y(0, 2.3);
  for (int p = 0; p < 4000; ++p) body.add({x(engine), y(engine)}, 1e-3, {0, 0});
  ParticleOrder order;
  locate(body, grid, order);
  // Every node of a strip's particles lies between one row below the strip and two above: the colouring's proof.
  for (int s = 0; s < grid.strip_count(); ++s)
    for (std::size_t p = order.strip_begin[s]; p < order.strip_begin[s + 1]; ++p)
      for (const auto& [I, w, gradient] : make_stencil(body, p, grid)) {
        EXPECT_GE(I / grid.stride(1), 4 * s - 1);
        EXPECT_LE(I / grid.stride(1), 4 * s + 5);
      }
  return body.size() - order.tail_begin();
}
TEST(Bspline, NoParticleIsTooWideForItsStrip) {
  EXPECT_EQ(wide_particles<QuadraticBspline>(), 0u);
  EXPECT_EQ(wide_particles<CubicBspline>(), 0u);
}

template <class Shape>
double worst_step() {
  Particle<Shape> particle;
  double worst = 10;
  for (int i = 0; i <= 4000; ++i) worst = std::min(worst, particle.step(5 + i / 4000.));
  return worst;
}
TEST(Bspline, CertainStepAtTheWorstOffset) {
  EXPECT_NEAR(worst_step<QuadraticBspline>(), 2 / std::sqrt(6.), 5e-4);  // just off the middle of a cell
  EXPECT_NEAR(worst_step<CubicBspline>(), 1.129, 1e-3);
  Particle<QuadraticBspline> quadratic;
  Particle<CubicBspline> cubic;
  EXPECT_NEAR(quadratic.step(5), 1, 1e-12);
  EXPECT_NEAR(cubic.step(5), 2 / std::sqrt(3.), 1e-12);
}

/// `share` is of Irons' step. Largest velocity seen in 1000 steps of a bar with random velocities of 1e-9 of the speed
/// of sound, relative to that; stops at 1e4.
template <class Shape>
double growth(double share) {
  Body<Shape, Hypoelastic, S> bar{"bar", {}, {1, 1, 0}};
  std::mt19937_64 engine{19};
  std::uniform_real_distribution<> v(-1e-9, 1e-9);
  for (int p = 0; p < 4 * cells; ++p) bar.add(Vector<S>{(p + 0.5) * h / 4}, h / 4, Vector<S>{v(engine)});
  Solver<Shape, Hypoelastic, Usl, S> solver{Grid<S>{Vector<S>{0.0}, h, {cells}}, std::move(bar)};
  for (int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};
  solver.safety = share / solver.integrator.step_factor();
  double largest = 0;
  for (int i = 0; i < 1000 && largest < 1e-5; ++i) {
    solver.step();
    for (int p = 0; p < 4 * cells; ++p) largest = std::max(largest, std::abs(solver.body().v(0)[p]));
  }
  return largest / 1e-9;
}
TEST(Bspline, StandsAtTheCertainStepAndFallsFarBeyond) {
  EXPECT_LT(growth<QuadraticBspline>(1), 3);
  EXPECT_LT(growth<CubicBspline>(1), 3);
  EXPECT_GT(growth<QuadraticBspline>(2.5), 1e4);
  EXPECT_GT(growth<CubicBspline>(2.5), 1e4);
}

}  // namespace
