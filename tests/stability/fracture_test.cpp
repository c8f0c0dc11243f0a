// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/modes/torn.hpp>

// A bar drawn out evenly, two particles a cell at first: once two neighbours share no node, neither feels the other.
namespace {

using namespace mpm;
using atlas::torn;

/// Some pairs are torn between the two stretches, by where they stand in their cells; none before, all after.
template <class Shape>
void expect_torn_between(double first, double last) {
  EXPECT_EQ(torn<Shape>(first - .1), 0);
  EXPECT_GT(torn<Shape>(first + .1), 0);
  EXPECT_LT(torn<Shape>(last - .1), 1);
  EXPECT_EQ(torn<Shape>(last + .1), 1);
}
TEST(NumericalFracture, DomainsThatKeepTheirSizeTear) {
  expect_torn_between<Linear>(2, 4);
  expect_torn_between<Ugimp>(3, 5);
  expect_torn_between<QuadraticBspline>(4, 6);
  expect_torn_between<CubicBspline>(6, 8);
}

// The boxes of cpGIMP are held at three cells, stretch 6 here; the ends of a segment are where its neighbours' are.
TEST(NumericalFracture, DomainsThatStretchHold) {
  for (double stretch = 1; stretch < 6; stretch += .35) EXPECT_EQ(torn<Cpgimp>(stretch), 0) << stretch;
  for (double stretch = 1; stretch < 20; stretch += .35) EXPECT_EQ(torn<Cpdi>(stretch), 0) << stretch;
}

}  // namespace
