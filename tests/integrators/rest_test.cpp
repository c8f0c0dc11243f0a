// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mpm/mpm.hpp>

// A stressed block between rollers, kicked at one corner: particles that the wave has not reached rest, and what comes
// out is what a solver finds that works on all of them.
namespace mpm {
namespace {

template <class SolverT>
struct LetRest : ::testing::Test {
  using B = typename SolverT::template BodyAt<0>;
  static constexpr int cells = 36;
  static constexpr double kick = 1, speed = 1e-5;

  static SolverT make() {
    const Hypoelastic law{.density = 1000, .young = 1e9, .poisson = .3};
    B block{"block", {}, law};
    fill(block, {0, 0}, {cells, cells}, .5);
    for (std::size_t p = 0; p < block.size(); ++p) {
      auto state = block.state(p);
      state.stress = {-5e6, -5e6, -3e6, 0, 0, 0};
      block.store(p, state);
      if (block.position(p).norm() < 3) block.v(0)[p] = kick;
    }
    SolverT solver{Grid<PlaneStrain<>>{{0, 0}, 1, {cells, cells}}, std::move(block)};
    for (int axis = 0; axis < 2; ++axis)
      for (int side = 0; side < 2; ++side) solver.boundary.face(axis, side) = Rollers<PlaneStrain<>>{};
    return solver;
  }
  /// Sleeping blocks.
  static int asleep(const SolverT& solver) {
    return int(std::count(solver.grid.asleep.begin(), solver.grid.asleep.end(), 1));
  }
};
using Solvers = ::testing::Types<Solver<Ugimp, Hypoelastic, Usl>, Solver<Ugimp, Hypoelastic, Musl>,
                                 Solver<Cpgimp, Hypoelastic, Usf>, Solver<CpdiQuad, Hypoelastic, Musl>,
                                 Solver<QuadraticBspline, Hypoelastic, Fmpm>, Solver<Cpdi, Hypoelastic, Usl>>;
TYPED_TEST_SUITE(LetRest, Solvers);

TYPED_TEST(LetRest, ChangesNothingThatMatters) {
  auto all = this->make(), some = this->make();
  some.let_rest(this->speed);
  const int at_first = this->asleep(some);
  EXPECT_GT(at_first, 60) << "of the 81 with particles";
  const double end = .45 * this->cells / std::sqrt(1e9 / 1000);  // the wave crosses the block after about .86
  all.run(end);
  some.run(end);
  EXPECT_LT(this->asleep(some), 2 * at_first / 3) << "the wave wakes what it reaches";
  EXPECT_GT(this->asleep(some), 0) << "and nothing beyond";
  // Particles of the two are in different orders: sums that tell any difference apart, and the fastest.
  double moving[2] = {}, strain[2] = {}, fastest[2] = {};
  TypeParam* solvers[2] = {&all, &some};
  for (int k = 0; k < 2; ++k) {
    const auto& b = solvers[k]->body();
    for (std::size_t p = 0; p < b.size(); ++p) {
      const auto x = b.position(p);
      moving[k] += b.v(0)[p] * std::sin(x[0] / 3) * std::cos(x[1] / 5);
      strain[k] += (b.stress(p).xx + 5e6) * std::cos(x[0] / 4) * std::cos(x[1] / 3);
      fastest[k] = std::max(fastest[k], b.velocity(p).norm());
    }
  }
  // Five thousand particles, each off by at most about the speed that wakes it, or that times the impedance.
  EXPECT_NEAR(moving[1], moving[0], 5e3 * this->speed);
  EXPECT_NEAR(strain[1], strain[0], 5e3 * this->speed * std::sqrt(1e9 * 1000));
  EXPECT_NEAR(fastest[1], fastest[0], 10 * this->speed);
  EXPECT_GT(fastest[0], .02 * this->kick);
}

TYPED_TEST(LetRest, SleepsOnWhereNothingHappens) {
  auto solver = this->make();
  auto& block = solver.body();
  for (std::size_t p = 0; p < block.size(); ++p) block.v(0)[p] = 0;
  solver.let_rest(this->speed);
  const int at_first = this->asleep(solver);
  for (int k = 0; k < 50; ++k) solver.step();
  EXPECT_EQ(this->asleep(solver), at_first);
}

}  // namespace
}  // namespace mpm
