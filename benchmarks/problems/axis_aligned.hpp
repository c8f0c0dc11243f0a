// SPDX-License-Identifier: MIT
#pragma once
#include "manufactured.hpp"

namespace mpm::problems {

struct AxisAlignedOptions {
  int cells = 16;           ///< along the unit edge
  int per_edge = 2;         ///< particles a cell edge
  double safety = 0.5;      ///< share of the stable step
  double amplitude = 0.05;  ///< A, m
};

/// Displacements along the axes of the unit interval, square or cube between rollers, over one period: the manufactured
/// solution of Wallstedt & Guilkey (2008). Error: relative L2 of the displacement over particles and steps.
template <int D, class Shape, class Integrator, class Scalar = double>
Outcome axis_aligned(const AxisAlignedOptions& options, Integrator integrator = {}) {
  using S = std::tuple_element_t<D - 1, std::tuple<Uniaxial<Scalar>, PlaneStrain<Scalar>, Spatial<Scalar>>>;
  using Law = WithOrigin<NeoHookean>;
  using Solution = analysis::AxisAligned<D>;
  const Solution solution{.amplitude = options.amplitude};
  std::array<int, D> cells;
  cells.fill(options.cells);
  Body<Shape, Law, S> body{"block", {}, {solution.material}};
  fill(body, Vector<S>::Zero(), Vector<S>::Ones(), Scalar(1) / Scalar(options.cells * options.per_edge));
  Solver<Shape, Law, Integrator, S, ManufacturedForce<Solution, S>> solver{
      Grid<S>{Vector<S>::Zero(), Scalar(1) / Scalar(options.cells), cells}, std::move(body)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  solver.body_force.solution = solution;
  for (int d = 0; d < D; ++d)
    for (int side : {0, 1}) solver.boundary.face(d, side) = Rollers<S>{};
  const double speed = std::sqrt(solution.material.young / solution.material.density);
  return run_manufactured(solver, 2 / speed);
}

}  // namespace mpm::problems
