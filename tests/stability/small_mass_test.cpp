// SPDX-License-Identifier: MIT
#include <mpm/mpm.hpp>
#include <gtest/gtest.h>

// A bar whose last particle has slid past a node by a millionth of a cell: the node beyond has next to no mass, and
// gives that particle a velocity gradient of any size.
namespace {

using namespace mpm;
using S = Uniaxial<>;

/// Largest stress over two crossings in the wave's own, rho c v. The bar is free, its last quarter struck. The step is
/// `cfl` h/c, or the certain one if that is 0.
template <class Shape, class Integrator>
double growth(double cfl) {
  constexpr int cells = 10;
  constexpr double v = 1e-9, past = 1e-6;
  Body<Shape, Hypoelastic, S> bar{"bar", {}, {.density = 1, .young = 1, .poisson = 0}};
  fill(bar, Vector<S>{0.0}, Vector<S>{cells + .5}, .5);
  for (std::size_t p = 0; p < bar.size(); ++p) {
    bar.x(0)[p] += .75 + past;  // the last one's centre is just beyond node 11
    bar.v(0)[p] = bar.x(0)[p] > 8 ? v : 0;
  }
  Solver<Shape, Hypoelastic, Integrator, S> solver{Grid<S>{Vector<S>{0.0}, 1, {cells + 5}}, std::move(bar)};
  double largest = 0;
  while (solver.time < 20 && largest < 1e3) {
    if (cfl > 0) {
      solver.safety = 1e9;
      solver.step(cfl);
    } else {
      solver.step();
    }
    for (std::size_t p = 0; p < solver.body().size(); ++p)
      largest = std::max(largest, std::abs(solver.body().stress(p).xx) / v);
  }
  return largest;
}

TEST(SmallMass, LastWithLinearShapesFallsAtAnyFixedStep) {
  for (const double cfl : {.8, .4, .1, .01}) EXPECT_GT((growth<Linear, Usl>(cfl)), 100) << cfl;
  EXPECT_LT((growth<Linear, Usl>(0)), 2);
}
TEST(SmallMass, WhatStandsAtAFixedStep) {
  EXPECT_LT((growth<Linear, Musl>(.4)), 2);
  EXPECT_LT((growth<QuadraticBspline, Usl>(.4)), 2);
  EXPECT_LT((growth<Ugimp, Usl>(.4)), 2);
}

}  // namespace
