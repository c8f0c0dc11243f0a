// SPDX-License-Identifier: MIT
// Two rubber discs collide and bounce off each other (Sulsky, Chen & Schreyer 1994).
#include <mpm/analysis/energy.hpp>
#include <mpm/mpm.hpp>
#include <cmath>
#include <cstdio>

int main() {
  mpm::Body<mpm::Cpgimp, mpm::NeoHookean> discs{"discs", {}, {.density = 1000, .young = 1000, .poisson = .3}};
  const auto add_disc = [&](double x, double y, double speed) {
    const auto inside = [=](const auto& at) { return std::hypot(at[0] - x, at[1] - y) < .2; };
    mpm::fill(discs, {0, 0}, {1, 1}, .025, inside, {speed, speed});
  };
  add_disc(.3, .3, .1);
  add_disc(.7, .7, -.1);

  const mpm::Grid<mpm::PlaneStrain<>> grid{{0, 0}, .05, {20, 20}};
  mpm::Solver<mpm::Cpgimp, mpm::NeoHookean, mpm::Musl> solver{grid, discs};
  for (const double time : {0., .5, 1., 1.5, 2., 2.5}) {
    solver.run(time);
    const double kinetic = mpm::kinetic_energy(solver.body()), strain = solver.body().stress_work;
    std::printf("%.1f s: kinetic energy %.3f J, strain energy %.3f J\n", time, kinetic, strain);
  }
}
