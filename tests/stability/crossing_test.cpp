// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <problems/axis_aligned.hpp>

// Particles that cross cells and domains that stretch, as the amplitude A of the manufactured waves along an axis
// grows; and what more particles a cell do. Errors in per cent of the displacement, relative L2; 64 cells if not said.
namespace {

using namespace mpm;

template <class Shape, class Integrator = Usl>
double error(double amplitude, int cells = 64, int per_edge = 2, double safety = .5) {
  return 100 * problems::axis_aligned<1, Shape, Integrator>(
                   {.cells = cells, .per_edge = per_edge, .safety = safety, .amplitude = amplitude})
                   .error;
}
void expect_within(double value, double low, double high) {
  EXPECT_GT(value, low);
  EXPECT_LT(value, high);
}

// As long as no particle leaves its cell, the linear shape is as good as any.
TEST(CellCrossing, LinearFalls) {
  expect_within(error<Linear>(.0005), .1, .25);
  expect_within(error<Linear>(.005), 3, 10);
  expect_within(error<Linear>(.05), 35, 80);
  expect_within(error<Linear>(.2), 60, 200);
}
TEST(CellCrossing, DomainsThatStretchStand) {
  for (const double amplitude : {.0005, .005, .05, .1, .2}) {
    EXPECT_LT(error<Cpgimp>(amplitude), .2) << amplitude;
    EXPECT_LT(error<Cpdi>(amplitude), .2) << amplitude;
    EXPECT_LT((error<Cpdi, Musl>(amplitude, 64, 2, .25)), .2) << amplitude;
  }
}
// Where domains stretch MUSL needs half the step that is certain for waves.
TEST(CellCrossing, ModifiedLastFallsAtTheUsualStep) {
  EXPECT_LT((error<Cpdi, Musl>(.05)), .2);
  expect_within(error<Cpdi, Musl>(.2), 6, 16);
  expect_within(error<Cpgimp, Musl>(.2), 6, 60);
}

// Strains of up to .63 at A = .2: boxes that keep their size leave gaps, and points are quadrature that fails.
TEST(GrowingStretch, WhatKeepsItsSizeFalls) {
  EXPECT_LT(error<Ugimp>(.005), .25);
  expect_within(error<Ugimp>(.1), 3, 7);
  expect_within(error<Ugimp>(.2), 10, 25);
  EXPECT_LT(error<QuadraticBspline>(.005), .3);
  expect_within(error<QuadraticBspline>(.1), 3, 7);
  expect_within(error<QuadraticBspline>(.2), 6, 13);
}
TEST(GrowingStretch, CubicSplinesNearlyStand) {
  EXPECT_LT(error<CubicBspline>(.05), .35);
  expect_within(error<CubicBspline>(.2), .4, .8);
}
// Points are the quadrature: more of them do not help the quadratic spline, and one a cell is too few for any but CPDI.
TEST(Quadrature, TheQuadraticSplineStalls) {
  for (const int per_edge : {2, 3, 4}) {
    expect_within(error<QuadraticBspline>(.05, 64, per_edge), .3, .7);
    expect_within(error<QuadraticBspline>(.05, 128, per_edge), .5, 1.2);  // coarser is better
  }
}
TEST(Quadrature, CubicSplinesAndDomainsStand) {
  const auto expect_second_order = [](double coarse, double fine) { EXPECT_NEAR(std::log2(coarse / fine), 2, .15); };
  expect_second_order(error<CubicBspline>(.05, 64, 4), error<CubicBspline>(.05, 128, 4));
  for (const int per_edge : {2, 4})
    expect_second_order(error<Cpgimp>(.05, 64, per_edge), error<Cpgimp>(.05, 128, per_edge));
  expect_second_order(error<Cpdi>(.05, 64, 1), error<Cpdi>(.05, 128, 1));
}
TEST(Quadrature, OneParticleACellFalls) {
  for (const int cells : {64, 128}) {
    EXPECT_GT(error<QuadraticBspline>(.05, cells, 1), 40) << cells;
    EXPECT_GT(error<CubicBspline>(.05, cells, 1), 30) << cells;
  }
  EXPECT_LT(error<Cpgimp>(.05, 32, 1), 1);
  EXPECT_GT(error<Cpgimp>(.05, 64, 1), 10);
}

}  // namespace
