// SPDX-License-Identifier: MIT
#include <problems/boxed_cavity.hpp>
#include <problems/charged_hole.hpp>
#include <gtest/gtest.h>

// What a scene needs, and what it does not: the peak hoop stress round a hole in more of space than there is variation
// in, by more gas than pushes, through air that carries nothing.
namespace {

using namespace mpm::problems;

TEST(BoxedCavity, IsTheSameInASlice) {
  const CavityOptions options{.cells = 4, .history_from = 1};
  const auto plane = boxed_cavity<mpm::PlaneStrain<>>(options), slice = boxed_cavity<mpm::Spatial<>>(options);
  EXPECT_EQ(slice.particles, 2 * plane.particles);
  for (const auto& e : {plane, slice}) {
    EXPECT_NEAR(100 * e.peak[0], .44, .1);
    EXPECT_NEAR(100 * e.peak[1], 1.21, .2);
  }
}

double apart(const ChargedHoleOutcome& a, const ChargedHoleOutcome& b) {
  return 100 * a.error_against(b);
}
TEST(ChargedHole, MoreGasParticlesOrAirChangeLittle) {
  const auto many = charged_hole({.cells = 2, .gas_per_edge = 20}), some = charged_hole({.cells = 2}),
             few = charged_hole({.cells = 2, .gas_per_edge = 2}), airless = charged_hole({.cells = 2, .air = false});
  EXPECT_NEAR(apart(few, many), 1.6, .4);
  EXPECT_LT(apart(some, many), .8);
  EXPECT_LT(apart(airless, some), .05);
  EXPECT_GT(many.particles, some.particles + 1000);
  EXPECT_EQ(airless.particles, 3692);
}

// Cells that resolve the gap do.
TEST(ChargedHole, FinerCellsChangeMuch) {
  const auto fine = radial_charged_hole({.cells = 32}), middle = radial_charged_hole({.cells = 8}),
             coarse = radial_charged_hole({.cells = 2});
  EXPECT_LT(apart(middle, fine), 6);
  EXPECT_NEAR(apart(coarse, fine), 27, 3);
  EXPECT_LT(apart(charged_hole({.cells = 2}), coarse), 5);
}

}  // namespace
