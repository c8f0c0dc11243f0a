// SPDX-License-Identifier: MIT
#pragma once
#include "manufactured.hpp"

namespace mpm::problems {

struct VortexOptions {
  int cells = 20;        ///< along 1 m
  int per_edge = 2;      ///< particles a cell edge
  double amplitude = 1;  ///< A, rad
  double safety = 0.2;   ///< share of the stable step at rest; the shear makes waves four times as fast
};

/// The generalized vortex (Kamojjala et al. 2015) on a polar mesh: the circles of a free ring turn against each other,
/// up to 1 rad and back in 1 s. Error: relative L2 of the displacement over particles and steps.
template <class Shape, class Integrator, class Scalar = double>
Outcome vortex(const VortexOptions& options, Integrator integrator = {}) {
  using S = PlaneStrain<Scalar>;
  using Law = WithOrigin<NeoHookean>;
  using Solution = analysis::Vortex;
  const Solution solution{.amplitude = options.amplitude};
  const double h = 1.0 / options.cells, size = h / options.per_edge;
  const int half = int(std::ceil(Solution::outer / h)) + 2;
  const geometry::Annulus ring{.inner = Solution::inner, .outer = Solution::outer, .particle_size = size};
  Solver<Shape, Law, Integrator, S, ManufacturedForce<Solution, S>> solver{
      Grid<S>{Vector<S>::Constant(Scalar(-half * h)), Scalar(h), {2 * half, 2 * half}},
      body_on<Shape, S>(ring.mesh(), Law{solution.material}, size)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  solver.body_force.solution = solution;
  return run_manufactured(solver, 1);
}

}  // namespace mpm::problems
