// SPDX-License-Identifier: MIT
#include <mpm/analysis/energy.hpp>
#include <mpm/mpm.hpp>
#include <gtest/gtest.h>

// Velocities that alternate from particle to particle within a cell: no node feels them.
namespace {

using namespace mpm;
using S = Uniaxial<>;

/// Share of the kinetic energy of a checkerboard that is left after 1000 steps.
template <class Integrator>
double left(const Integrator& integrator) {
  constexpr int cells = 20;
  constexpr double v = 1e-6;  // of the wave speed
  Body<Linear, Hypoelastic, S> bar{"bar", {}, {.density = 1, .young = 1}};
  fill(bar, Vector<S>{0.0}, Vector<S>{double(cells)}, .5);
  for (std::size_t p = 0; p < bar.size(); ++p) bar.v(0)[p] = p % 2 ? v : -v;
  Solver<Linear, Hypoelastic, Integrator, S> solver{Grid<S>{Vector<S>{0.0}, 1, {cells}}, std::move(bar)};
  solver.integrator = integrator;
  for (const int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};
  const double start = kinetic_energy(solver.body());
  for (int k = 0; k < 1000; ++k) solver.step();
  return kinetic_energy(solver.body()) / start;
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
