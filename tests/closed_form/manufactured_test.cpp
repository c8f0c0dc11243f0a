// SPDX-License-Identifier: MIT
#include "problems/axis_aligned.hpp"
#include <gtest/gtest.h>

// Displacements along the axes in one, two and three dimensions against the manufactured solution, held to what each
// method reaches and to its order. The error is the relative L2 norm of the displacement over particles and steps.
namespace {

using namespace mpm;
using problems::axis_aligned;

/// The error on so many cells, and on twice as many that error over 2^order.
template <int D, class Shape, class IntegratorType>
void expect_error_and_order(const IntegratorType& integrator, const problems::AxisAlignedOptions& options, double error,
                            double order) {
  auto finer = options;
  finer.cells *= 2;
  const double coarse = axis_aligned<D, Shape>(options, integrator).error;
  const double fine = axis_aligned<D, Shape>(finer, integrator).error;
  EXPECT_LT(coarse, 1.2 * error);
  EXPECT_GT(coarse, 0.8 * error);
  EXPECT_NEAR(std::log2(coarse / fine), order, 0.2);
}

TEST(AxisAligned, Line) {
  expect_error_and_order<1, Cpgimp>(Usl{}, {.cells = 16}, 2.6e-2, 2);
  expect_error_and_order<1, Cpdi>(Usl{}, {.cells = 16}, 2.7e-2, 2);
  expect_error_and_order<1, Cpdi>(Musl{}, {.cells = 16}, 2.7e-2, 2);
  expect_error_and_order<1, Cpdi>(Apic{}, {.cells = 16}, 1.35e-2, 2);
  expect_error_and_order<1, CubicBspline>(Usl{}, {.cells = 16, .per_edge = 4}, 4.3e-2, 2);
}
/// Straining with the velocities of the last step is of first order in time, whatever the shape.
TEST(AxisAligned, StressFirstIsOfFirstOrder) {
  expect_error_and_order<1, Cpdi>(Usf{}, {.cells = 32}, 5.7e-2, 1);
}
TEST(AxisAligned, Square) {
  expect_error_and_order<2, Cpgimp>(Usl{}, {.cells = 8}, 9.7e-2, 2);
  expect_error_and_order<2, Cpdi>(Usl{}, {.cells = 8}, 9.8e-2, 2);
  expect_error_and_order<2, CpdiQuad>(Usl{}, {.cells = 8}, 9.8e-2, 2);
  expect_error_and_order<2, Cpgimp>(FullMassFlip{.order = 4, .strain_share = 0.5}, {.cells = 8}, 3.8e-2, 2);
}
/// Four cells along the edge are few: 1.8 is on its way to 2.
TEST(AxisAligned, Cube) {
  expect_error_and_order<3, Cpgimp>(Usl{}, {.cells = 4}, 0.35, 1.85);
}

/// The best there is: cubic splines, many particles, and the full mass matrix in acceleration and strain.
TEST(AxisAligned, BestOfAll) {
  const problems::AxisAlignedOptions options{.cells = 16, .per_edge = 8};
  const double flip = axis_aligned<1, CubicBspline>(options, Usl{}).error;
  const double best = axis_aligned<1, CubicBspline>(options, FullMassFlip{.order = 8, .strain_share = 1}).error;
  EXPECT_LT(best, 8e-5);
  EXPECT_GT(flip, 500 * best);
}

/// How many times FMPM(k) is better than FLIP at an amplitude.
template <class Shape>
double gain(int order, double amplitude, double strain_share = .5, int per_edge = 2) {
  const problems::AxisAlignedOptions options{.cells = 32, .per_edge = per_edge, .amplitude = amplitude};
  const Fmpm fmpm{.order = order, .strain_share = strain_share};
  return axis_aligned<1, Shape>(options, Usl{}).error / axis_aligned<1, Shape>(options, fmpm).error;
}
/// The dispersion that FMPM cancels is nearly all the error of a small wave, but not of one that strains by 16 %.
TEST(AxisAligned, FmpmGainsMostOnSmallWaves) {
  EXPECT_NEAR(gain<Cpgimp>(2, 1e-4), 11, 1.5);
  EXPECT_NEAR(gain<Cpgimp>(4, 1e-4), 18, 2);
  EXPECT_NEAR(gain<Cpdi>(2, 1e-4), 10.6, 1.2);
  EXPECT_NEAR(gain<Cpdi>(4, 1e-4), 16.7, 2);
  for (int order : {2, 4}) {
    EXPECT_NEAR(gain<Cpgimp>(order, 0.05), 3.2, 0.4) << order;
    EXPECT_NEAR(gain<Cpdi>(order, 0.05), 4.2, 0.5) << order;
  }
}

/// Strained with v(k) alone, splines gain most, and the more terms the more; boxes by chance at one
/// amplitude, where two errors cancel. With v+ alone no shape gains much.
TEST(AxisAligned, FmpmGainsMostOnSplines) {
  EXPECT_NEAR(gain<CubicBspline>(8, 1e-4, 1, 4), 180, 20);
  EXPECT_NEAR(gain<CubicBspline>(8, 0.05, 1, 4), 120, 12);
  EXPECT_NEAR(gain<QuadraticBspline>(4, 1e-4, 1, 4), 84, 9);
  EXPECT_NEAR(gain<Cpgimp>(4, 0.05, 1), 19, 2);
  EXPECT_NEAR(gain<Cpgimp>(4, 1e-4, 1), 1.8, 0.2);
  EXPECT_NEAR(gain<Cpdi>(4, 0.05, 0), 1.6, 0.2);
  EXPECT_NEAR(gain<CubicBspline>(8, 0.05, 0, 4), 1.3, 0.2);
}

/// Points cross cells: with the linear shape the error grows with the resolution. GIMP whose boxes keep their size
/// stalls.
TEST(AxisAligned, CellCrossing) {
  const auto error = [](auto shape, int cells) {
    return axis_aligned<1, decltype(shape)>({.cells = cells}, Usl{}).error;
  };
  EXPECT_GT(error(Linear{}, 16), 0.15);
  EXPECT_GT(error(Linear{}, 32), 1.5 * error(Linear{}, 16));
  EXPECT_NEAR(error(Ugimp{}, 16), 0.041, 0.006);
  EXPECT_GT(error(Ugimp{}, 64), 4 * error(Cpgimp{}, 64));
}

}  // namespace
