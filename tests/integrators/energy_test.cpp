// SPDX-License-Identifier: MIT
#include "scene.hpp"
#include <numbers>

// How each stress update treats energy: a bar fixed at one end, one half struck with a step velocity, ten periods.
namespace mpm::integrator_laws {
namespace {

/// Change of total energy (kinetic and stress work) relative to the start, of a bar 20 cells long.
template <class IntegratorType>
double energy_change(double flip = 1) {
  using S = Uniaxial<>;
  const int cells = 20;
  const double length = 1, h = length / cells, E = 100, rho = 1, v = 0.01;
  Body<Cpdi, Hypoelastic, S> bar{"bar", {}, {rho, E, 0}};
  fill(bar, Vector<S>{0.0}, Vector<S>{length}, h / 2);
  for (std::size_t p = 0; p < bar.size(); ++p) bar.v(0)[p] = bar.x(0)[p] > length / 2 ? v : 0;
  Solver<Cpdi, Hypoelastic, IntegratorType, S> solver{Grid<S>{Vector<S>{0.0}, h, {cells + 2}}, std::move(bar)};
  solver.integrator.flip = flip;
  solver.boundary.face(0, 0) = Rollers<S>{};
  const double c = std::sqrt(E / rho), period = 4 * length / c;
  const double start = kinetic_energy(solver.body());
  while (solver.time < 10 * period) solver.step(0.4 * h / c);
  return (kinetic_energy(solver.body()) + solver.body().stress_work) / start - 1;
}

TEST(StressUpdate, LastLosesEnergy) {
  EXPECT_NEAR(energy_change<Usl>(), -0.098, 0.01);
}
TEST(StressUpdate, FirstGainsALittle) {
  EXPECT_NEAR(energy_change<Usf>(), 0.005, 0.004);
}
TEST(StressUpdate, ModifiedLastKeepsIt) {
  EXPECT_NEAR(energy_change<Musl>(), -0.001, 0.003);
}
TEST(StressUpdate, PicLosesAll) {
  EXPECT_NEAR(energy_change<Musl>(0), -0.92, 0.02);
}

}  // namespace
}  // namespace mpm::integrator_laws
