// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/energy.hpp>
#include "../law.hpp"

namespace mpm::atlas {

/// Velocities that alternate from particle to particle within a cell: no node feels them. Returns the share of their
/// kinetic energy that is left after 1000 steps; `after(step, share)` is called after every step.
template <class Shape, class Integrator, class After>
double checkerboard(const Integrator& integrator, const After& after) {
  using S = Uniaxial<>;
  constexpr int cells = 20;
  constexpr double v = 1e-6;  // of the wave speed
  Body<Shape, Law, S> bar{"bar", {}, {{.density = 1, .young = 1}}};
  fill(bar, Vector<S>{0.0}, Vector<S>{double(cells)}, .5);
  for (std::size_t p = 0; p < bar.size(); ++p) bar.v(0)[p] = p % 2 ? v : -v;
  Solver<Shape, Law, Integrator, S> solver{Grid<S>{Vector<S>{0.0}, 1, {cells}}, std::move(bar)};
  solver.integrator = integrator;
  for (const int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};
  const double start = kinetic_energy(solver.body());
  for (int k = 1; k <= 1000; ++k) {
    solver.step();
    after(k, kinetic_energy(solver.body()) / start);
  }
  return kinetic_energy(solver.body()) / start;
}

}  // namespace mpm::atlas
