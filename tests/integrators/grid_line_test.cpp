// SPDX-License-Identifier: MIT
#include <mpm/mpm.hpp>
#include <gtest/gtest.h>

// A pre-stressed block whose edge all but touches a grid line: its outermost nodes hold next to nothing.
namespace {

using namespace mpm;

/// Largest distance along y of a particle from the block's middle after three steps; it starts at .125.
template <class Shape, class IntegratorT>
double extent(double offset) {
  constexpr double cell = .1;
  Body<Shape, Hypoelastic> block{"block", {}, {.density = 1000, .young = 1e6, .poisson = .3}};
  fill(block, {.3 + offset, .3 + offset}, {.6 + offset, .6 + offset}, cell / 2);
  for (std::size_t p = 0; p < block.size(); ++p) block.store(p, {.stress = {-1e4, -1e4, 0, 0, 0, 0}});
  Solver<Shape, Hypoelastic, IntegratorT> solver{Grid<PlaneStrain<>>{{0, 0}, cell, {9, 9}}, std::move(block)};
  for (int k = 0; k < 3; ++k) solver.step();
  double largest = 0;
  for (std::size_t p = 0; p < solver.body().size(); ++p)
    largest = std::max(largest, std::abs(solver.body().x(1)[p] - .45 - offset));
  return largest;
}

template <class Shape>
void expect_calm() {
  for (const double offset : {0., 1e-14, -1e-13, 1e-12, 1e-9, 1e-6}) {
    EXPECT_NEAR((extent<Shape, Usl>(offset)), .1255, .0005) << offset;
    EXPECT_NEAR((extent<Shape, Musl>(offset)), .126, .001) << offset;
    EXPECT_NEAR((extent<Shape, Usf>(offset)), .126, .001) << offset;
  }
}

TEST(GridLine, StretchingBoxesAtOneStayCalm) {
  expect_calm<Cpgimp>();
}
TEST(GridLine, RigidBoxesAtOneStayCalm) {
  expect_calm<Ugimp>();
}
TEST(GridLine, ParallelogramsAtOneStayCalm) {
  expect_calm<Cpdi>();
}

}  // namespace
