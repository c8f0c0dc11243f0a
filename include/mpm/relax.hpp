// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/solver.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace mpm {

/// When a relaxation is at rest.
struct RelaxationOptions {
  double tolerance = 1e-6;         ///< of the unbalanced force, see `relax`
  std::int64_t max_steps = 20000;  ///< before giving up
  int check_every = 10;            ///< steps between two tests
};

/// How a relaxation ended.
struct RelaxationReport {
  std::int64_t steps = 0;       ///< taken
  double unbalanced_force = 0;  ///< norm of the free nodes' forces over that of sum abs(V sigma grad w), all nodes
  double kinetic_ratio = 0;     ///< kinetic energy of the nodes over the elastic energy, sum V sigma:sigma/(2 M)
};

namespace detail {

/// Sum V sigma:sigma/(2 M) over all bodies, M the longitudinal tangent modulus, J.
template <class SolverT>
double elastic_energy_scale(SolverT& solver) {
  double sum = 0;
  solver.for_bodies([&](const auto& body) {
    for (std::size_t p = 0; p < body.size(); ++p) {
      const auto stress = body.stress(p);
      const auto M = body.law.tangent(body.state(p), body.relative_volume(p)).longitudinal;
      sum += double(body.volume()[p] * inner(stress, stress) / (2 * M));
    }
  });
  return sum;
}

}  // namespace detail

/// Steps a solver of DynamicRelaxation until it is at rest; calls `after(solver)` after each step.
///
/// The test is Eq 31 of Xiao et al. 2024, Processes 12, 1048, with the norm of the unbalanced force over the free
/// nodes, against that of the forces that balance, sum abs(V sigma grad w), over all nodes: a body pressed between
/// walls needs the constrained ones to have a scale. Force and motion must both be small *in the same step*:
///   unbalanced_force <= tolerance   and   kinetic_ratio <= (tolerance n)^2, n the cells along the longest axis.
/// A mode that swings with the relative amplitude e hides its force as it passes through equilibrium and its motion as
/// it turns, but never both: its energy e^2 is their sum, and modes add up. The least force for an e is that of the
/// longest wave, about e/n, which is why the two tests together bound e at any phase, and under any damping, by about n
/// times the tolerance. Throws Error if `max_steps` pass first.
template <class SolverT, class After>
RelaxationReport relax(SolverT& solver, const RelaxationOptions& options, const After& after) {
  int cells = 0;
  for (int d = 0; d < decltype(solver.grid)::dimension; ++d) cells = std::max(cells, solver.grid.cells(d));
  const double kinetic_tolerance = std::pow(options.tolerance * cells, 2);
  const auto over = [](double value, double scale) { return value > 0 ? value / scale : 0; };
  RelaxationReport report;
  while (report.steps < options.max_steps) {
    solver.step();
    after(solver);
    if (++report.steps % options.check_every != 0 && report.steps < options.max_steps) continue;
    report.unbalanced_force = over(solver.integrator.force_norm, solver.force_scale());
    report.kinetic_ratio = over(solver.integrator.kinetic, detail::elastic_energy_scale(solver));
    if (report.unbalanced_force <= options.tolerance && report.kinetic_ratio <= kinetic_tolerance) return report;
  }
  std::ostringstream text;
  text << "relax: not at rest after " << report.steps << " steps: unbalanced force " << report.unbalanced_force
       << " (tolerance " << options.tolerance << "), kinetic ratio " << report.kinetic_ratio << " (tolerance "
       << kinetic_tolerance << "); raise max_steps or the tolerance, or look for a body that nothing holds";
  throw Error(text.str());
}
template <class SolverT>
RelaxationReport relax(SolverT& solver, const RelaxationOptions& options = {}) {
  return relax(solver, options, [](const SolverT&) {});
}

}  // namespace mpm
