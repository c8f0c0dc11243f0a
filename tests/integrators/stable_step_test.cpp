// SPDX-License-Identifier: MIT
#include "scene.hpp"
#include <mpm/materials/presets.hpp>
#include <numbers>

// What the step is reduced by, beside what the stiffness allows.
namespace mpm::integrator_laws {
namespace {

/// Stable step of a uniform gas, in h/c, whose volume changes at the rate `closing` c/h.
double step_of_gas(const BulkViscosity& viscosity, double closing) {
  using S = PlaneStrain<>;
  PolynomialEos law = air();
  law.viscosity = viscosity;
  Body<Linear, PolynomialEos> gas{"gas", {}, law};
  fill(gas, {0, 0}, {6 * cell, 6 * cell}, cell / 2);
  const double c = std::sqrt(law.tangent(law.initial<double>(), 1.0).longitudinal / law.density);
  Grid<S> grid{{0, 0}, cell, {6, 6}};
  for (std::size_t n = 0; n < grid.size(); ++n) grid.velocity[n] = closing * c / cell / 2 * grid.position(int(n));
  return stable_step(gas, ChunkList(gas.size()), grid) * c / cell;
}

/// Von Neumann & Richtmyer's condition, 1/(sqrt(1 + x^2) + x) with x = c1 + c0 h |tr D|/c: .06 + 1.5 x .3 = .51.
TEST(StableStep, BulkViscosityShrinksItUnderCompression) {
  const BulkViscosity none{0, 0}, usual{1.5, .06};
  const double plain = step_of_gas(none, -0.2);
  EXPECT_NEAR(plain, std::sqrt(4 / (2 * (4 + 4 / 3.0))), 1e-12);  // 2/sqrt(sum of grad w^2/w): points at the quarters
  EXPECT_NEAR(step_of_gas(usual, -0.3) / plain, 0.61254, 1e-5);
  EXPECT_NEAR(step_of_gas({0, .06}, -0.2) / plain, 0.94180, 1e-5);
  EXPECT_EQ(step_of_gas(usual, 0.2), plain);
}

/// A tenth of a strain a step, however soft the gas.
TEST(StableStep, StrainIsAtMostATenth) {
  const double rate = 5;  // c/h, of the volume: 5/sqrt 2 in the norm of D
  EXPECT_NEAR(step_of_gas({0, 0}, -rate), 0.1 * std::sqrt(2.0) / rate, 1e-12);
}

/// uGIMP as one writes a shape at first: its stencil, and nothing for the fast passes.
struct PlainUgimp : private Ugimp {
  using Ugimp::bytes, Ugimp::check, Ugimp::domain_motion, Ugimp::half_size, Ugimp::max_nodes, Ugimp::permute,
      Ugimp::reach, Ugimp::stencil;
};

/// The step follows the places of particles whose shape has no fast passes, too.
TEST(StableStep, IsThatOfTheFastPassesWithoutThem) {
  auto fast = block<Ugimp, Usl, PlaneStrain<>>(9);
  auto plain = block<PlainUgimp, Usl, PlaneStrain<>>(9);
  double shortest = 1, longest = 0;
  for (auto* v : {fast.body().v(1), plain.body().v(1)})
    for (std::size_t p = 0; p < fast.body().size(); ++p) v[p] = sound_speed() / 20;
  for (int k = 0; k < 40; ++k) {
    const double dt = fast.step();
    ASSERT_NEAR(plain.step(), dt, 1e-9 * dt) << k;
    shortest = std::min(shortest, dt), longest = std::max(longest, dt);
  }
  EXPECT_GT(longest, 1.2 * shortest);
}

/// What the last step knew of the particles does not hold for one that has come since.
TEST(StableStep, CountsAParticleAddedBetweenSteps) {
  auto solver = block<Ugimp, Usl, PlaneStrain<>>(9);
  const double before = solver.step(), speed = 100 * sound_speed();
  solver.body().add({3.3 * cell, 3.3 * cell}, cell * cell / 4, {speed, 0});
  const double after = solver.step();
  EXPECT_LT(after, before / 10);
  EXPECT_LE(after, solver.safety * cell / 2 / speed);
}

/// Largest stress, in the starting one, over 400 steps of a single particle in the middle of a cell.
template <class IntegratorT>
double growth(double share_of_irons) {
  Body<Linear, Hypoelastic, Uniaxial<>> body("particle", {}, {});
  body.add(Vector<Uniaxial<>>(0.5), 1, Vector<Uniaxial<>>(0));
  auto state = body.state(0);
  state.stress.xx = 1;
  body.store(0, state);
  Solver<Linear, Hypoelastic, IntegratorT, Uniaxial<>> solver(Grid<Uniaxial<>>{Vector<Uniaxial<>>(0), 1, {1}}, body);
  solver.safety = share_of_irons / solver.integrator.step_factor();
  double largest = 0;
  for (int k = 0; k < 400; ++k) {
    solver.step();
    largest = std::max(largest, std::abs(solver.body().stress(0).xx));
  }
  return largest;
}

/// Velocities that the remap has not smoothed halve the dt^2 that is stable: sqrt(1/2) of Irons' step.
TEST(StableStep, UslStandsAtItsOwnFactorAndFallsBeyond) {
  EXPECT_LT(growth<Usl>(Usl{}.step_factor()), 10);
  EXPECT_GT(growth<Usl>(0.75), 1e4);
  EXPECT_LT(growth<Musl>(1), 10);
  EXPECT_LT(growth<Usf>(1), 10);
}

/// Where the quarter point of a bar in its first mode is after 1.2 periods, in amplitudes, with steps of `dt` h/c; the
/// first period's eighth takes four times as many.
double swing(double dt) {
  using S = Uniaxial<>;
  constexpr double length = 8, amplitude = 1e-9;
  Body<QuadraticBspline, Hypoelastic, S> bar("bar", {}, {.density = 1, .young = 1, .poisson = 0});
  fill(bar, Vector<S>(0), Vector<S>(length), .5);
  for (std::size_t p = 0; p < bar.size(); ++p)
    bar.v(0)[p] = amplitude * std::sin(std::numbers::pi * bar.x(0)[p] / length);
  Solver<QuadraticBspline, Hypoelastic, Musl, S> solver(Grid<S>{Vector<S>(0), 1, {int(length)}}, bar);
  for (int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};
  const double start = solver.body().x(0)[4], period = 2 * length;
  while (solver.time < 1.2 * period)
    solver.step(std::min(solver.time < period / 8 ? dt / 4 : dt, 1.2 * period - solver.time));
  return (solver.body().x(0)[4] - start) / (amplitude * length / std::numbers::pi);
}

/// Velocities stand half a step before the stresses: a step of another length shifts them, which would be an error of
/// first order if the forces did not allow for it.
TEST(StableStep, MayChangeAtSecondOrder) {
  const double exact = swing(.4 / 64), coarse = std::abs(swing(.4) - exact), fine = std::abs(swing(.2) - exact);
  EXPECT_LT(coarse, 4e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2, .2);
}

}  // namespace
}  // namespace mpm::integrator_laws
