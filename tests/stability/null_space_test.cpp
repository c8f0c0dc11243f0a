// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/modes/checkerboard.hpp>

// Velocities that alternate from particle to particle within a cell: no node feels them.
namespace {

using namespace mpm;

/// Share of the kinetic energy of a checkerboard that is left after 1000 steps.
template <class Integrator>
double left(const Integrator& integrator) {
  return atlas::checkerboard<Linear>(integrator, [](int, double) {});
}

TEST(NullSpace, FlipKeepsItForEver) {
  EXPECT_NEAR(left(Usl{}), 1, 1e-9);
  EXPECT_NEAR(left(Musl{}), 1, 1e-9);
  EXPECT_NEAR(left(Usf{}), 1, 1e-9);
}
TEST(NullSpace, PicAndFilteredVelocitiesRemoveIt) {
  EXPECT_LT(left(Musl{.flip = 0}), 1e-20);
  EXPECT_LT(left(Fmpm{.order = 2}), 1e-20);
  EXPECT_LT(left(Fmpm{.order = 4}), 1e-20);
  EXPECT_LT(left(Musl{.flip = .99}), 1e-7);  // a little of PIC is enough
}

}  // namespace
