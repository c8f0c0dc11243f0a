// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/modes/cook.hpp>

// Cook's membrane: deflection over that of finite elements.
namespace {

using namespace mpm;
using atlas::cook;

TEST(Locking, UniformGimpLocks) {
  EXPECT_NEAR(cook<Ugimp>({.poisson = .3, .cell = 4}), 1, .02);
  const double locked = cook<Ugimp>({.poisson = .499, .cell = 4});
  EXPECT_GT(locked, .65);
  EXPECT_LT(locked, .75);
}

TEST(Locking, MeanDilatationDoesNot) {
  for (const double poisson : {.3, .499})
    for (const double cell : {4., 3.}) {
      const double deflection = cook<MeanDilatation<Ugimp>>({.poisson = poisson, .cell = cell});
      EXPECT_NEAR(deflection, 1, .02) << poisson << ", cells of " << cell << " m";
    }
}

}  // namespace
