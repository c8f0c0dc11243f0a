// SPDX-License-Identifier: MIT
#include <problems/sod.hpp>
#include <gtest/gtest.h>

namespace {

using namespace mpm;

template <class Shape, class Integrator>
double error(int cells, int per_edge, const Integrator& integrator = {}) {
  return problems::sod<Shape>({.cells = cells, .per_edge = per_edge}, integrator).error;
}

// Shock, contact and the corners of the fan are jumps of a profile or its slope: order one is all there is.
TEST(Sod, QuadraticSplinesConverge) {
  const Fmpm fmpm{.order = 4};
  const double coarse = error<QuadraticBspline>(50, 8, fmpm), middle = error<QuadraticBspline>(100, 8, fmpm),
               fine = error<QuadraticBspline>(200, 8, fmpm);
  EXPECT_LT(fine, .007);
  for (const double order : {std::log2(coarse / middle), std::log2(middle / fine)}) {
    EXPECT_GT(order, .9);
    EXPECT_LT(order, 1.1);
  }
}

// Thinned to 1.7 particles a cell, the left gas leaves gaps between boxes that keep their size: more particles close
// them.
TEST(Sod, MoreParticlesDoNoHarm) {
  const Fmpm fmpm{.order = 4};
  EXPECT_LT((error<QuadraticBspline>(200, 16, fmpm)), 1.02 * error<QuadraticBspline>(200, 4, fmpm));
  EXPECT_LT((error<QuadraticBspline, Musl>(100, 16)), 1.05 * (error<QuadraticBspline, Musl>(100, 4)));
  const double few = error<Ugimp, Musl>(200, 4), many = error<Ugimp, Musl>(200, 16);
  EXPECT_NEAR(few, .0139, .0015);
  EXPECT_LT(many, .95 * few);
}

// Lumped masses and the remap smear more than FMPM does.
template <class Shape>
void expect_error(double musl, double usl) {
  EXPECT_NEAR((error<Shape, Musl>(100, 8)), musl, .08 * musl);
  EXPECT_NEAR((error<Shape, Usl>(100, 8)), usl, .08 * usl);
}
TEST(Sod, EveryShapeRuns) {
  expect_error<Linear>(.0211, .0216);
  expect_error<Ugimp>(.0208, .0209);
  expect_error<Cpgimp>(.0210, .0209);
  expect_error<Cpdi>(.0222, .0223);
  expect_error<QuadraticBspline>(.0241, .0242);
  expect_error<CubicBspline>(.0278, .0279);
}

}  // namespace
