// SPDX-License-Identifier: MIT
#include "problems/expanding_ring.hpp"
#include <gtest/gtest.h>

// The expanding ring with free rims against the manufactured solution, in quadrilaterals on a polar mesh.
namespace {

using namespace mpm;

/// The error on cells of 50 mm and of 25 mm: second order.
template <class Shape, class IntegratorType>
void expect_error(const IntegratorType& integrator, double error) {
  const double coarse = problems::expanding_ring<Shape>({.cells = 20}, integrator).error;
  const double fine = problems::expanding_ring<Shape>({.cells = 40}, integrator).error;
  EXPECT_LT(coarse, 1.2 * error);
  EXPECT_GT(coarse, 0.8 * error);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.15);
}

TEST(ExpandingRing, IsOfSecondOrder) {
  expect_error<CpdiQuad>(Usl{}, 9.8e-3);
  expect_error<CpdiQuad>(Apic{}, 4.8e-3);
  expect_error<CpdiQuad>(FullMassFlip{.order = 4}, 5.4e-3);
  expect_error<CpdiQuad>(FullMassFlip{.order = 4, .strain_share = 0.5}, 4.1e-3);
  expect_error<CpdiQuad>(Fmpm{.order = 4}, 4.1e-3);
}
/// Boxes along the axes overlap and gape on a polar mesh, and do not get better with it.
TEST(ExpandingRing, BoxesDoNotFitAPolarMesh) {
  EXPECT_GT(problems::expanding_ring<Cpgimp>({.cells = 40}, Usl{}).error, 0.01);
}

}  // namespace
