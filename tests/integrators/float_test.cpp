// SPDX-License-Identifier: MIT
#include "scene.hpp"
#include <mpm/materials/presets.hpp>

// The whole step in float, held against double.
namespace mpm::integrator_laws {
namespace {

/// Velocities of a few per cent of the speed of sound that differ from particle to particle, but not from scalar to
/// scalar.
template <class Body>
void stir(Body& body, double speed) {
  for (std::size_t p = 0; p < body.size(); ++p)
    for (int d = 0; d < Body::dimension; ++d)
      body.v(d)[p] = typename Body::Scalar(speed * std::sin(3.0 * double(p % 7) + 2.0 * double(p % 3) + d));
}

/// Compares place, velocity, volume and stress, each in the largest change that the step has made.
template <class A, class B>
void expect_close(const A& exact, const B& rounded, const A& start, double tolerance) {
  ASSERT_EQ(exact.size(), rounded.size());
  double moved = 0, speed = 0, strain = 0, stress = 0;
  for (std::size_t p = 0; p < exact.size(); ++p) {
    moved = std::max(moved, (exact.position(p) - start.position(p)).norm());
    speed = std::max(speed, exact.velocity(p).norm());
    strain = std::max(strain, std::abs(exact.volume()[p] / start.volume()[p] - 1));
    const auto change = exact.stress(p) - start.stress(p);
    stress = std::max(stress, std::sqrt(inner(change, change)));
  }
  ASSERT_GT(moved, 0.01 * cell);
  ASSERT_GT(strain, 1e-3);
  for (std::size_t p = 0; p < exact.size(); ++p) {
    const auto x = (exact.position(p) - rounded.position(p).template cast<double>()).norm();
    const auto v = (exact.velocity(p) - rounded.velocity(p).template cast<double>()).norm();
    const auto s = exact.stress(p);
    const auto t = rounded.stress(p);
    EXPECT_LT(x, tolerance * moved);
    EXPECT_LT(v, tolerance * speed);
    EXPECT_LT(std::abs(double(rounded.volume()[p]) - exact.volume()[p]), tolerance * strain * exact.volume()[p]);
    for (const double off : {s.xx - double(t.xx), s.yy - double(t.yy), s.zz - double(t.zz), s.xy - double(t.xy)})
      EXPECT_LT(std::abs(off), tolerance * stress);
  }
  EXPECT_NEAR(exact.stress_work, rounded.stress_work,
              tolerance * (kinetic_energy(start) + std::abs(exact.stress_work)));
}

template <class Shape>
class FloatStep : public ::testing::Test {};
// A new shape costs one line.
using Shapes = ::testing::Types<Linear, Ugimp, Cpgimp, Cpdi, CpdiQuad, QuadraticBspline, CubicBspline>;
TYPED_TEST_SUITE(FloatStep, Shapes);

TYPED_TEST(FloatStep, FollowsDouble) {
  auto exact = block<TypeParam, Musl, PlaneStrain<>>(9);
  auto rounded = block<TypeParam, Musl, PlaneStrain<float>>(9);
  stir(exact.body(), 0.02 * sound_speed());
  rounded.body() = std::remove_cvref_t<decltype(rounded.body())>(exact.body());
  const auto start = exact.body();
  for (int i = 0; i < 40; ++i) {
    const double dt = exact.step(0.2 * cell / sound_speed());
    ASSERT_NEAR(rounded.step(dt) / dt, 1, 1e-6);
  }
  expect_close(exact.body(), rounded.body(), start, 1e-3);
}

/// A block flies over several blocks of nodes and keeps its velocity: its places are found again on the way.
TYPED_TEST(FloatStep, FliesFar) {
  auto solver = block<TypeParam, Musl, PlaneStrain<float>>(60);
  auto& body = solver.body();
  for (std::size_t p = 0; p < body.size(); ++p) body.v(1)[p] = 10;
  const float start = body.x(1)[0];
  while (body.x(1)[0] < start + 40 * float(cell)) solver.step();
  for (std::size_t p = 0; p < body.size(); ++p) {
    EXPECT_NEAR(body.v(1)[p], 10, 1e-3);
    EXPECT_NEAR(body.v(0)[p], 0, 1e-3);
  }
}

/// Rock, gas and rubber side by side, with walls and a quiet face.
template <class Scalar>
auto mixed() {
  using S = PlaneStrain<Scalar>;
  using V = Vector<S>;
  Body<CpdiQuad, Hypoelastic, S> rock{"rock", {}, {density, 1e7, 0.3}};
  Body<Ugimp, PolynomialEos, S> gas{"gas", {}, air()};
  Body<Cpgimp, NeoHookean, S> rubber{"rubber", {}, {density, young, 0.3}};
  gas.law.density = 100;
  const auto spacing = Scalar(cell / 2);
  const auto at = [](double x, double y) { return V(Scalar(cell * x), Scalar(cell * y)); };
  fill(rock, at(0, 0), at(3, 5.5), spacing);
  fill(gas, at(3, 0), at(6, 5.5), spacing);
  fill(rubber, at(6, 0), at(8.5, 5.5), spacing);
  stir(rock, 0.5);
  stir(rubber, 0.5);
  using AllShapes = PerBody<CpdiQuad, Ugimp, Cpgimp>;
  using AllLaws = PerBody<Hypoelastic, PolynomialEos, NeoHookean>;
  Solver<AllShapes, AllLaws, Usl, S> solver{Grid<S>{V::Zero(), Scalar(cell), {10, 12}}, std::move(rock), std::move(gas),
                                            std::move(rubber)};
  solver.boundary.face(0, 0) = Quiet<S>::from(Scalar(density), Moduli<Scalar>{Scalar(1e7), Scalar(4e6)});
  solver.boundary.face(1, 0) = Rollers<S>{};
  solver.body_force[1] = Scalar(-9.81);
  return solver;
}

TEST(FloatStep, FollowsDoubleWithMixedBodies) {
  auto exact = mixed<double>();
  auto rounded = mixed<float>();
  const auto start = exact.bodies;
  for (int i = 0; i < 40; ++i) {
    const double dt = exact.step(1e-4);
    ASSERT_NEAR(rounded.step(dt) / dt, 1, 1e-6);
  }
  expect_close(exact.body<0>(), rounded.body<0>(), std::get<0>(start), 1e-3);
  expect_close(exact.body<1>(), rounded.body<1>(), std::get<1>(start), 1e-3);
  expect_close(exact.body<2>(), rounded.body<2>(), std::get<2>(start), 1e-3);
  EXPECT_LT(exact.boundary.work(), 0);
  EXPECT_NEAR(rounded.boundary.work() / exact.boundary.work(), 1, 1e-3);
}

}  // namespace
}  // namespace mpm::integrator_laws
