// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mpm/mpm.hpp>
#include <cmath>
#include <limits>
#include <regex>

// What a run that cannot go on says: which body, which particle, where, when, and what to do.
namespace {

using namespace mpm;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The message of the Error that `work` throws, or "no error".
template <class F>
std::string message(const F& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}
void expect_match(const std::string& text, const std::string& pattern) {
  EXPECT_TRUE(std::regex_search(text, std::regex(pattern))) << "message: " << text << "\npattern: " << pattern;
}

template <class Shape, class IntegratorType = Usl>
auto block() {
  Body<Shape, Hypoelastic> rock{"rock", {}, {2000, 1e9, .2}};
  fill(rock, {1, 1}, {2, 2}, .05);
  return Solver<Shape, Hypoelastic, IntegratorType>{Grid<PlaneStrain<>>{{0, 0}, .1, {30, 30}}, std::move(rock)};
}
template <class Solver>
std::string steps(Solver& solver, int count) {
  return message([&] {
    for (int i = 0; i < count; ++i) solver.step();
  });
}
const std::string rock_particle = "^particle \\d+ of rock at \\(", when = ", in step \\d+ at [0-9.e+-]+ s: .{10}";

TEST(Faults, LeavingTheGrid) {
  auto solver = block<Ugimp>();
  for (std::size_t p = 0; p < solver.body().size(); ++p) solver.body().v(0)[p] = 50;
  const auto text = steps(solver, 2000);
  expect_match(text, rock_particle + "3\\.\\d+, [12]\\.\\d+\\) m has left the grid" + when);
  EXPECT_GT(solver.steps, 0);
}

TEST(Faults, NowhereIsOffTheGrid) {
  auto solver = block<Linear>();
  solver.body().x(1)[7] = nan;
  expect_match(steps(solver, 1), "^particle 7 of rock at \\([0-9.]+, -?nan\\) m has left the grid" + when);
}

TEST(Faults, VelocityNotANumber) {
  auto solver = block<Ugimp>();
  EXPECT_EQ(steps(solver, 1), "no error");
  solver.body().v(0)[11] = nan;
  expect_match(steps(solver, 1), "^particle 11 of rock .* velocity that is no finite number, in step 1 at");
}

TEST(Faults, StressNotANumber) {
  auto solver = block<Cpdi>();
  EXPECT_EQ(steps(solver, 1), "no error");
  solver.body().store(13, {.stress = {.xx = nan}});
  expect_match(steps(solver, 1), "^particle 13 of rock .* stress that is no finite number, in step 1 at");
}

TEST(Faults, LawThatReturnsNoNumber) {
  auto solver = block<Ugimp>();
  EXPECT_EQ(steps(solver, 1), "no error");
  solver.body().law.young = nan;
  expect_match(steps(solver, 1), rock_particle + ".*" + when);
}

TEST(Faults, NegativeVolume) {
  auto solver = block<Ugimp>();
  EXPECT_EQ(steps(solver, 1), "no error");
  solver.body().volume()[5] = -1e-6;
  expect_match(steps(solver, 1), "^particle 5 of rock .* volume that is not positive, in step 1 at");
}

TEST(Faults, StepBelowTheFloor) {
  auto solver = block<Ugimp>();
  EXPECT_EQ(steps(solver, 1), "no error");
  solver.body().law.young *= 1e14;
  solver.bodies_changed();
  const auto text = steps(solver, 1);
  expect_match(text, rock_particle +
                         ".* allows a step of [0-9.e-]+ s, less than 1e-06 of the first.*stiffness of .* Pa" + ".*" +
                         when);
  solver.step_floor = 0;
  EXPECT_EQ(steps(solver, 1), "no error");
}
TEST(Faults, StepBelowTheFloorForItsSpeed) {
  auto solver = block<Ugimp>();
  EXPECT_EQ(steps(solver, 1), "no error");
  for (std::size_t p = 0; p < solver.body().size(); ++p) solver.body().v(1)[p] = 1e10;
  solver.bodies_changed();
  expect_match(steps(solver, 1), rock_particle + ".*as it moves at 1e\\+10 m/s" + when);
}

/// What the guard says of a block that swings, taking so many of its certain steps at a time.
std::string guarded(double certain_steps) {
  auto solver = block<Ugimp>();
  for (std::size_t p = 0; p < solver.body().size(); ++p)
    solver.body().v(0)[p] = 1e-3 * std::sin(9 * solver.body().x(0)[p]), solver.body().v(1)[p] = p % 2 ? 1e-5 : -1e-5;
  solver.safety = certain_steps;
  return message([&] {
    EnergyGuard guard;
    for (int k = 0; k < 500; ++k) solver.step(), guard(solver);
  });
}
TEST(Faults, EnergyFromNowhere) {
  const auto text = guarded(2);
  expect_match(text, rock_particle + ".* m moves at [0-9.e+-]+ m/s and is the fastest .* has gained [0-9.e+-]+ J");
  expect_match(text, when);
  EXPECT_EQ(guarded(.8), "no error");
}
TEST(Faults, EnergyOfFacesAndWeightIsExplained) {
  auto solver = block<Ugimp>();
  for (const int axis : {0, 1})
    for (const int side : {0, 1}) solver.boundary.face(axis, side) = Rollers<PlaneStrain<>>{};
  solver.body_force = {0, -1000};
  EnergyGuard guard;
  EXPECT_EQ(message([&] { solver.run(.03, [&](auto& s) { guard(s); }); }), "no error");
  EXPECT_GT(kinetic_energy(solver.body()), 0);
}

TEST(Faults, StressFailsDuringRelaxationToo) {
  auto solver = block<Ugimp, DynamicRelaxation<>>();
  EXPECT_EQ(steps(solver, 3), "no error");
  solver.body().store(13, {.stress = {.xx = nan}});
  expect_match(steps(solver, 1), rock_particle + ".*" + when);
}

/// A closed box of dust, every particle on its own way: corners end up beyond the diagonals of their quadrilaterals.
TEST(Faults, InvertedQuadrilateral) {
  Body<CpdiQuad, Hypoelastic> dust{"dust", {}, {2000, 1, .2}};
  fill(dust, {0, 0}, {1, 1}, .05);
  for (std::size_t p = 0; p < dust.size(); ++p)
    dust.v(0)[p] = 10 * std::sin(7. * double(p)), dust.v(1)[p] = 10 * std::cos(5. * double(p));
  Solver<CpdiQuad, Hypoelastic, Usl> solver{Grid<PlaneStrain<>>{{0, 0}, .1, {10, 10}}, std::move(dust)};
  for (int axis : {0, 1})
    for (int side : {0, 1}) solver.boundary.face(axis, side) = Rollers<PlaneStrain<>>{};
  const auto text = steps(solver, 3000);
  expect_match(text, "^particle \\d+ of dust at .* has a domain turned inside out" + when);
  expect_match(text, "refine the grid there, lower `safety`, or take a shape that cannot invert");
}

TEST(Faults, ShapesUnfitForWork) {
  const auto first_step = [](auto shape, const char* name) {
    Body<decltype(shape), Hypoelastic> body{name, shape, {2000, 1e9, .2}};
    body.add({1, 1}, .01, {0, 0});
    Solver<decltype(shape), Hypoelastic, Usl> solver{Grid<PlaneStrain<>>{{0, 0}, .1, {20, 20}}, std::move(body)};
    return steps(solver, 1);
  };
  const std::string remedy = "set it to half the spacing";
  expect_match(first_step(Ugimp{}, "gas"), "body gas: shape.half_size\\[0\\] is 0 m and must be positive.*" + remedy);
  expect_match(first_step(Ugimp{{.05, .06, 0}}, "gas"), "half_size\\[1\\] is 0.06 m .* at most half a cell");
  EXPECT_EQ(first_step(Ugimp{{.05, .05, 0}}, "gas"), "no error");
  expect_match(first_step(Cpgimp{{.05, -1, 0}}, "rock"), "body rock: shape.half_size\\[1\\] is -1 m and must be pos");
  expect_match(first_step(Cpdi{{nan, .1, 0}}, "rock"), "body rock: shape.half_size\\[0\\] is -?nan m");
  expect_match(first_step(CpdiQuad{}, "rock"), "body rock: 1 particles but 0 quadrilaterals; .*add_quad");
}

TEST(Faults, QuadrilateralGivenClockwise) {
  Body<CpdiQuad, Hypoelastic> body{"rock", {}, {}};
  body.shape.corner = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  expect_match(message([&] { add_quad(body, {0, 1, 2, 3}); }), "body rock: .* volume -1; it must be positive");
}

TEST(Faults, ParticlesThatCannotBe) {
  Body<Linear, Hypoelastic> body{"rock", {}, {2000, 1e9, .2}};
  const auto add = [&](double volume, double J) { return message([&] { body.add({0, 0}, volume, {0, 0}, J); }); };
  expect_match(add(0, 1), "body rock: particle 0 would have the volume 0; it must be positive");
  expect_match(add(-1e-9, 1), "volume -1e-09");
  expect_match(add(nan, 1), "volume -?nan");
  expect_match(add(1, 0), "relative volume 0");
  body.law.density = -2000;
  expect_match(add(1, 1), "body rock: particle 0 would have the density -2000");
  EXPECT_EQ(body.size(), 0u);
}

TEST(Faults, LawsThatCannotBe) {
  for (const double poisson : {.5, .6, -1., nan}) {
    auto solver = block<Linear>();
    solver.body().law.poisson = poisson;
    expect_match(steps(solver, 1), "body rock: the law's stiffness at rest is no finite positive number.*Poisson's");
    EXPECT_EQ(solver.steps, 0);
  }
}

TEST(Faults, FillingWithAnotherSize) {
  Body<Ugimp, Hypoelastic> body{"gas", {}, {}};
  fill(body, {0, 0}, {1, 1}, .5);
  EXPECT_EQ(body.size(), 4u);
  expect_match(message([&] { fill(body, {0, 0}, {1, 1}, .25); }), "body gas have another size");
  expect_match(message([&] { fill(body, {0, 0}, {1, 1}, 0); }), "spacing of body gas must be positive");
}

TEST(Faults, GridsThatCannotBe) {
  expect_match(message([] { Grid<PlaneStrain<>>{{0, 0}, 0, {1, 1}}; }), "cell must be positive");
  expect_match(message([] { Grid<PlaneStrain<>>{{0, 0}, 1, {1, 0}}; }), "axis 1 has no cell");
}

}  // namespace
