// SPDX-License-Identifier: MIT
#include <mpm/materials/hypoelastic.hpp>
#include <mpm/mpm.hpp>
#include <mpm/relax.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

// The static test of a relaxation: a bar held at one end, pulled at the other, started off balance in its lowest mode
// alone, so that all its force vanishes at one time as it swings, and all its motion at another.
namespace {

using Line = mpm::Uniaxial<>;
using Bar = mpm::Solver<mpm::Cpgimp, mpm::Hypoelastic, mpm::DynamicRelaxation<mpm::Damping::fixed>, Line>;

constexpr int cells = 20;
constexpr double length = 1, pull = 1, period = 4 * length;  // wave speed 1

Bar bar(double share_of_critical) {
  mpm::Body<mpm::Cpgimp, mpm::Hypoelastic, Line> body("bar", {{length / (4 * cells)}},
                                                      {.density = 1e6, .young = 1e6, .poisson = 0});
  for (int i = 0; i < 2 * cells; ++i) {
    const double x = (i + .5) * length / (2 * cells);
    body.add(mpm::Vector<Line>(x), length / (2 * cells), mpm::Vector<Line>(0.0));
    body.store(std::size_t(i), {{.xx = pull * (1 + std::cos(std::numbers::pi * x / (2 * length)))}});
  }
  Bar solver(mpm::Grid<Line>(mpm::Vector<Line>(0.0), length / cells, {cells}), std::move(body));
  solver.boundary.face(0, 0) = mpm::Rollers<Line>{};
  solver.boundary.face(0, 1) =
      mpm::Traction<Line>::on(solver.grid, 0, 1, [](const auto&) { return mpm::Vector<Line>(pull); });
  solver.integrator.frequency = share_of_critical * 2 * std::numbers::pi / period;
  return solver;
}

/// Error of the bar's mean stress, in the load: what swings in the lowest mode, and not the pattern within a cell that
/// no node feels.
double error(Bar& solver) {
  double mean = 0;
  for (std::size_t p = 0; p < solver.body().size(); ++p) mean += solver.body().stress(p).xx / (2 * cells * pull);
  return std::abs(mean - 1);
}

/// Relaxes, then lets go of the damping for a period of the lowest mode: what was moving, or waiting at a turning
/// point, shows.
double error_once_let_go(double share_of_critical) {
  Bar solver = bar(share_of_critical);
  mpm::relax(solver, {.tolerance = 1e-3, .check_every = 1});
  solver.integrator.frequency = 0;
  double worst = error(solver);
  solver.run(solver.time + period, [&](Bar& s) { worst = std::max(worst, error(s)); });
  return worst;
}

TEST(Relax, DoesNotStopWhereASwingingBarTurnsOrPasses) {
  EXPECT_LT(error_once_let_go(.02), .04);
}

TEST(Relax, DoesNotTakeCreepForRest) {
  EXPECT_LT(error_once_let_go(10), .04);
}

TEST(Relax, ReportsWhatItHeld) {
  Bar solver = bar(1);
  int calls = 0;
  const auto report = mpm::relax(solver, {.tolerance = 1e-6}, [&](const Bar&) { ++calls; });
  EXPECT_EQ(report.steps, calls);
  EXPECT_LE(report.unbalanced_force, 1e-6);
  EXPECT_LE(report.kinetic_ratio, std::pow(1e-6 * cells, 2));
  EXPECT_LT(error(solver), 1e-4);
}

TEST(Relax, SaysWhatToDoWhenItDoesNotEnd) {
  Bar solver = bar(.02);
  try {
    mpm::relax(solver, {.max_steps = 50});
    FAIL();
  } catch (const mpm::Error& e) {
    EXPECT_NE(std::string(e.what()).find("not at rest after 50 steps"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("raise max_steps"), std::string::npos) << e.what();
  }
}

}  // namespace
