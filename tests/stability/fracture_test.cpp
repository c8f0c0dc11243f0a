// SPDX-License-Identifier: MIT
#include <mpm/mpm.hpp>
#include <gtest/gtest.h>

// A bar drawn out evenly, two particles a cell at first: once two neighbours share no node, neither feels the other.
namespace {

using namespace mpm;
using S = Uniaxial<>;

/// Share of the pairs of neighbours that are torn apart at a stretch.
template <class Shape>
double torn(double stretch) {
  constexpr int particles = 60;
  using Bar = Body<Shape, Hypoelastic, S>;
  Bar bar{"bar", {}, {}};
  fill(bar, Vector<S>{0.0}, Vector<S>{particles / 2.0}, .5);
  for (std::size_t p = 0; p < bar.size(); ++p) {
    bar.x(0)[p] = 10 + (stretch + 1e-4) * bar.x(0)[p];
    if constexpr (Bar::stores_F) bar.store_F(p, {stretch + 1e-4, 0, 0, 0, 1, 0, 0, 0, 1});
  }
  const Grid<S> grid{Vector<S>{0.0}, 1, {int(stretch * particles / 2) + 20}};
  const auto meet = [&](std::size_t p) {
    for (const auto& a : make_stencil(bar, p, grid))
      for (const auto& b : make_stencil(bar, p + 1, grid))
        if (a.node == b.node && a.weight > 1e-12 && b.weight > 1e-12) return true;
    return false;
  };
  int count = 0;
  for (std::size_t p = 0; p + 1 < bar.size(); ++p) count += !meet(p);
  return double(count) / (particles - 1);
}

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
