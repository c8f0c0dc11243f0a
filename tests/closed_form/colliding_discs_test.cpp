// SPDX-License-Identifier: MIT
#include <problems/colliding_discs.hpp>
#include <gtest/gtest.h>

namespace {

using namespace mpm;
using problems::CollidingDiscsRecord;

template <class Shape, class Integrator>
CollidingDiscsRecord collision(int cells = 20) {
  CollidingDiscsRecord record;
  problems::colliding_discs<Shape, Integrator>({.cells = cells}, {}, &record);
  return record;
}

/// The discs come to rest but for what swings in them, part again, and the total momentum stays zero.
void expect_bounce(const CollidingDiscsRecord& record) {
  EXPECT_LT(record.momentum, 1e-14);
  EXPECT_LT(record.least_kinetic, .06);
  EXPECT_NEAR(record.rebound, -.93, .03);
}

template <class Shape>
class CollidingDiscs : public ::testing::Test {};
using Shapes = ::testing::Types<Ugimp, Cpgimp, Cpdi, CpdiQuad, QuadraticBspline>;
TYPED_TEST_SUITE(CollidingDiscs, Shapes);

TYPED_TEST(CollidingDiscs, ModifiedLastKeepsTheEnergy) {
  const CollidingDiscsRecord record = collision<TypeParam, Musl>();
  expect_bounce(record);
  EXPECT_LT(std::abs(record.energy_change), .013);
  EXPECT_GT(record.energy_low, -.028);
  EXPECT_LT(record.energy_high, .018);
}

// Velocities that the remap has not smoothed yet strain the discs, and what it smooths is lost.
TYPED_TEST(CollidingDiscs, LastLosesEnergy) {
  const CollidingDiscsRecord record = collision<TypeParam, Usl>();
  expect_bounce(record);
  EXPECT_NEAR(record.energy_change, -.09, .03);
}

TEST(CollidingDiscsRefined, LastLosesHalf) {
  const double coarse = collision<Cpgimp, Usl>().energy_change, fine = collision<Cpgimp, Usl>(40).energy_change;
  EXPECT_NEAR(coarse / fine, 1.95, .3);
}

TEST(CollidingDiscsFirst, GainsALittle) {
  const CollidingDiscsRecord record = collision<Cpdi, Usf>();
  expect_bounce(record);
  EXPECT_NEAR(record.energy_change, .0067, .003);
}

}  // namespace
