// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/energy.hpp>
#include "../law.hpp"

namespace mpm::atlas {

/// A bar fixed at one end, one half of it struck with a step velocity, ten periods, in steps of .4 h/c or the certain
/// ones where these are shorter. Returns the change of kinetic
/// energy and stress work, relative to the start; `after(periods, change)` is called after every step.
template <class Shape, class Integrator, class After>
double struck_bar(const Integrator& integrator, int cells, const After& after) {
  using S = Uniaxial<>;
  const double h = 1. / cells, c = 10, period = 4 / c;
  Body<Shape, Law, S> bar{"bar", {}, {{.density = 1, .young = c * c, .poisson = 0}}};
  fill(bar, Vector<S>{0.0}, Vector<S>{1.0}, h / 2);
  for (std::size_t p = 0; p < bar.size(); ++p) bar.v(0)[p] = bar.x(0)[p] > .5 ? .01 : 0;
  Solver<Shape, Law, Integrator, S> solver{Grid<S>{Vector<S>{0.0}, h, {cells + 2}}, std::move(bar)};
  solver.integrator = integrator;
  solver.boundary.face(0, 0) = Rollers<S>{};
  const auto energy = [&] { return kinetic_energy(solver.body()) + solver.body().stress_work; };
  const double start = energy();
  while (solver.time < 10 * period) {
    solver.step(.4 * h / c);
    after(solver.time / period, energy() / start - 1);
  }
  return energy() / start - 1;
}

}  // namespace mpm::atlas
