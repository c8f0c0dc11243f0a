// SPDX-License-Identifier: MIT
#include "scene.hpp"
#include <algorithm>
#include <numbers>

// What the faces of the grid do to the bodies' energy, in sign and amount, and that they do nothing where no body is.
namespace mpm::integrator_laws {
namespace {

constexpr double E = 100, rho = 1, c = 10, length = 1;

/// A bar along x from the left face of the grid to the right one, one cell high, that can only move along x.
auto bar(int cells) {
  using S = PlaneStrain<>;
  const double h = length / cells;
  Body<Cpdi, Hypoelastic> body{"bar", {}, {rho, E, 0}};
  fill(body, {0, 0}, {length, h}, h / 2);
  Solver<Cpdi, Hypoelastic, Musl> solver{Grid<S>{{0, 0}, h, {cells, 1}}, std::move(body)};
  for (int side : {0, 1}) solver.boundary.face(1, side) = Rollers<S>{};
  solver.boundary.face(0, 0) = Fixed<S>{};
  return solver;
}
template <class Solver>
double energy(Solver& solver) {
  return kinetic_energy(solver.body()) + solver.body().stress_work;
}
template <class Solver, class Face>
double work_of(Solver& solver, int axis, int side, const Face&) {
  return std::get<Face>(solver.boundary.face(axis, side)).work;
}

/// A wave of the velocity v behind a front that runs from the pulled end to the wall: work T v t, v = T/(rho c).
TEST(BoundaryWork, ATractionDoesTheWorkThatTheBarTakesUp) {
  using S = PlaneStrain<>;
  auto solver = bar(40);
  const double h = solver.grid.cell(), T = 0.1, end = 0.8 * length / c;
  solver.boundary.face(0, 1) = Traction<S>::on(solver.grid, 0, 1, [&](const auto&) { return Vector<S>{T, 0}; });
  solver.run(end);
  const double exact = h * T * T / (rho * c) * end, work = work_of(solver, 0, 1, Traction<S>{});
  EXPECT_NEAR(work, exact, 0.02 * exact);
  EXPECT_NEAR(energy(solver), work, 0.01 * work);
  EXPECT_EQ(solver.boundary.work(), work);
  solver.run(20 * end);  // the wave has come and gone many times, and the fixed end and the rollers have held it
  EXPECT_EQ(work_of(solver, 0, 0, Fixed<S>{}), 0);
  for (int side : {0, 1}) EXPECT_EQ(work_of(solver, 1, side, Rollers<S>{}), 0);
  EXPECT_NEAR(energy(solver), solver.boundary.work(), 0.03 * exact);
}

/// A pulse leaves a bar in tension: it takes its own energy away, and the held stress does s0 u as the end moves by u.
TEST(BoundaryWork, AQuietFaceTakesAPulseOutAndPaysForTheHeldStress) {
  using S = PlaneStrain<>;
  constexpr double pi = std::numbers::pi, width = 0.4, v = 1e-3;
  for (const double s0 : {0.0, 0.05}) {
    auto solver = bar(80);
    auto& body = solver.body();
    for (std::size_t p = 0; p < body.size(); ++p) body.store(p, {.stress = {.xx = s0}});
    solver.boundary.face(0, 1) = Quiet<S>::from(rho, body.law.tangent(body.state(0), 1.0));
    solver.hold_quiet_faces();
    for (std::size_t p = 0; p < body.size(); ++p) {
      const double x = body.x(0)[p] - 0.3;
      if (x < 0 || x > width) continue;
      body.v(0)[p] = v * std::pow(std::sin(pi * x / width), 2);
      body.store(p, {.stress = {.xx = s0 - rho * c * body.v(0)[p]}});
    }
    const double h = solver.grid.cell(), start = energy(solver);
    const double pulse = h * rho * v * v * width * 3 / 8, moved = v * width / 2 / c;
    EXPECT_NEAR(2 * start, pulse, 1e-3 * pulse);  // the other half is in the stress
    solver.run(1.2 * length / c);
    const double work = solver.boundary.work();
    EXPECT_NEAR(work, h * s0 * moved - pulse, 0.01 * pulse) << s0;
    EXPECT_NEAR(energy(solver) - start, work, 0.01 * pulse) << s0;
    EXPECT_LT(kinetic_energy(body), 1e-3 * pulse);
  }
}

/// A block that moves away from a face; `solver` has its condition on the lower x face. Nothing acts on it once the
/// last of it has gone, on no node, and nothing has piled up there.
template <class Solver>
void expect_nothing_once_gone(Solver& solver) {
  auto& body = solver.body();
  const auto leftmost = [&] { return *std::min_element(body.x(0), body.x(0) + body.size()); };
  while (leftmost() < 1.5 * cell) solver.step();
  const double work = solver.boundary.work();
  const auto speed = momentum(body);
  EXPECT_NE(work, 0);
  while (leftmost() < 14 * cell) {
    solver.step();
    ASSERT_EQ(solver.boundary.work(), work) << solver.time;
  }
  EXPECT_LT((momentum(body) - speed).norm(), 1e-12 * speed.norm());
  solver.grid.for_each_on_face(0, 0, [&](int node, const auto&) {
    EXPECT_EQ(solver.grid.mass[node], 0);
    EXPECT_EQ(solver.grid.increment[node].norm(), 0);
  });
}
auto leaving_block() {
  Body<Ugimp, Hypoelastic> body{"block", {}, {density, young, 0.3}};
  fill(body, {0, 2 * cell}, {3 * cell, 5 * cell}, cell / 2);
  for (std::size_t p = 0; p < body.size(); ++p) body.v(0)[p] = 10;
  return Solver<Ugimp, Hypoelastic, Musl>{Grid<PlaneStrain<>>{{0, 0}, cell, {20, 7}}, std::move(body)};
}

TEST(BoundaryWork, ATractionDoesNotPushWhereNoBodyIs) {
  using S = PlaneStrain<>;
  auto solver = leaving_block();
  solver.boundary.face(0, 0) = Traction<S>::on(solver.grid, 0, 0, [](const auto&) { return Vector<S>{1e3, 0}; });
  expect_nothing_once_gone(solver);
  EXPECT_GT(solver.boundary.work(), 0);
}

TEST(BoundaryWork, AQuietFaceHoldsNothingWhereNoBodyIs) {
  using S = PlaneStrain<>;
  auto solver = leaving_block();
  auto& body = solver.body();
  for (std::size_t p = 0; p < body.size(); ++p) body.store(p, {.stress = {.xx = -1e3}});
  auto quiet = Quiet<S>::from(density, body.law.tangent(body.state(0), 1.0));
  quiet.normal_impedance /= 100;  // soft, or it draws the block back before it is gone
  solver.boundary.face(0, 0) = quiet;
  solver.hold_quiet_faces();
  expect_nothing_once_gone(solver);
}

/// Domains so tall that only the blocks of their own nodes are in use, at a face whose last block holds its nodes
/// alone: that block falls idle in the step in which they leave.
TEST(BoundaryWork, ATractionDoesNotPushAnIdleBlock) {
  using S = PlaneStrain<>;
  Body<Cpdi, Hypoelastic> body{"sheet", {{cell / 4, 6 * cell, 0}}, {density, young, 0.3}};
  for (const double x : {19.25, 19.75}) body.add({x * cell, 7 * cell}, cell / 2 * 12 * cell, {-10, 0});
  Solver<Cpdi, Hypoelastic, Musl> solver{Grid<S>{{0, 0}, cell, {20, 14}}, std::move(body)};
  solver.boundary.face(0, 1) = Traction<S>::on(solver.grid, 0, 1, [](const auto&) { return Vector<S>{-1e3, 0}; });
  const auto right_edge = [&] { return std::max(solver.body().x(0)[0], solver.body().x(0)[1]) + cell / 4; };
  while (right_edge() > 18.9 * cell) solver.step();
  const double work = solver.boundary.work();
  EXPECT_GT(work, 0);
  while (right_edge() > 14 * cell) solver.step();
  EXPECT_EQ(solver.boundary.work(), work);
  solver.grid.for_each_on_face(0, 1, [&](int node, const auto&) { EXPECT_EQ(solver.grid.mass[node], 0); });
}

}  // namespace
}  // namespace mpm::integrator_laws
