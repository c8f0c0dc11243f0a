// SPDX-License-Identifier: MIT
#pragma once
#include "manufactured.hpp"

namespace mpm::problems {

struct ExpandingRingOptions {
  int cells = 40;       ///< along 1 m; the ring is .2 m thick
  int per_edge = 2;     ///< particles a cell edge
  double safety = 0.5;  ///< share of the stable step at rest
};

/// The expanding ring (Wallstedt & Guilkey 2008), a quarter between rollers on a polar mesh, over one period: it grows
/// and shrinks by .1 m at its outer rim of .6 m, both rims free. Error: relative L2 of the displacement over particles
/// and steps.
template <class Shape, class Integrator, class Scalar = double>
Outcome expanding_ring(const ExpandingRingOptions& options, Integrator integrator = {}) {
  using S = PlaneStrain<Scalar>;
  using Law = WithOrigin<NeoHookean>;
  using Solution = analysis::ExpandingRing;
  const Solution solution;
  const double h = 1.0 / options.cells, size = h / options.per_edge;
  const int side = int(std::ceil((solution.outer + solution.amplitude) / h)) + 2;
  const geometry::Annulus ring{solution.inner, solution.outer, size, geometry::Model::quarter};
  Solver<Shape, Law, Integrator, S, ManufacturedForce<Solution, S>> solver{
      Grid<S>{Vector<S>::Zero(), Scalar(h), {side, side}},
      body_on<Shape, S>(ring.mesh(), Law{solution.material}, size)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  solver.body_force.solution = solution;
  for (int d : {0, 1}) solver.boundary.face(d, 0) = Rollers<S>{};
  const double speed = std::sqrt(solution.material.young / solution.material.density);
  return run_manufactured(solver, 2 * (solution.inner + solution.outer) / speed);
}

}  // namespace mpm::problems
