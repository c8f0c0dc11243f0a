// SPDX-License-Identifier: MIT
#pragma once
#include "holed_rock.hpp"
#include "outcome.hpp"
#include <numbers>

// Linear elastic rock with a hole, relaxed under far-field stress, against Kirsch's solution.
namespace mpm::problems {

enum class Start {
  exact,      ///< with Kirsch's stress at every particle: only what the discretisation leaves unbalanced is relaxed
  far_field,  ///< with the far field: the relaxation finds what the hole does to it
  nothing     ///< without stress: the relaxation finds all of it
};

struct KirschOptions {
  double cells = 4;         ///< cells on a radius a of the hole
  int per_edge = 2;         ///< particles an edge of a cell
  double safety = .8;       ///< share of the stable step
  double side = 20;         ///< side of the quarter model, radii
  double vertical = -40e6;  ///< far-field stress along y, Pa
  double ratio = .25;       ///< k, horizontal over vertical
  Start start = Start::exact;
  double tolerance = 1e-6;  ///< of the unbalanced force, see mpm::relax
};

/// Errors are relative to the larger far-field stress.
struct KirschOutcome : Outcome {   // error: all in-plane components for r >= 3 a, L2
  double wall_0 = 0, wall_90 = 0;  ///< of the hoop stress on the wall at 0 and 90 degrees, signed

  double worst_wall() const { return std::max(std::abs(wall_0), std::abs(wall_90)); }
};

namespace detail {

/// L2 norm over the particles with r >= `inner` of the difference from the exact in-plane stresses, Pa.
template <class Body>
double stress_error(const Body& body, const analysis::Kirsch& exact, double inner) {
  double sum = 0, area = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const double x = double(body.x(0)[p]), y = double(body.x(1)[p]), V = double(body.volume()[p]);
    if (std::hypot(x, y) < inner) continue;
    const auto s = body.stress(p);
    const auto t = exact.stress(x, y);
    sum += V * (std::pow(s.xx - t.xx, 2) + std::pow(s.yy - t.yy, 2) + 2 * std::pow(s.xy - t.xy, 2));
    area += V;
  }
  return std::sqrt(sum / area);
}

}  // namespace detail

/// A quarter of the rock, relaxed. Kirsch's traction pulls its outer faces from any start: the far field's own would be
/// that of a finite block. Throws Error as mpm::relax.
template <class Shape = CpdiQuad, class Integrator = DynamicRelaxation<>, class Scalar = double>
KirschOutcome kirsch(const KirschOptions& options, const Integrator& integrator = {}) {
  using Space = PlaneStrain<Scalar>;
  const double horizontal = options.ratio * options.vertical;
  const analysis::Kirsch kirsch{.horizontal = horizontal, .vertical = options.vertical, .radius = hole};
  const auto exact = [&](double x, double y) { return kirsch.stress(x, y); };
  const auto far = [&](double, double) { return analysis::PlanarStress{horizontal, options.vertical, 0}; };
  const auto rock = granite_elastic();
  Solver<Shape, Hypoelastic, Integrator, Space> solver(
      holed_block_grid<Space>(options.side, options.cells),
      geometry::make_body<Space>("rock", holed_block(options.side, options.cells, options.per_edge).mesh(), rock));
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  roll_on_axes(solver);
  pull_outer_faces(solver, exact);
  if (options.start == Start::exact) set_stress(solver.body(), rock.poisson, exact);
  if (options.start == Start::far_field) set_stress(solver.body(), rock.poisson, far);

  KirschOutcome outcome;
  const double start = processor_seconds();
  outcome.steps = relax(solver, {.tolerance = options.tolerance}).steps;
  outcome.seconds = processor_seconds() - start;
  outcome.particles = std::int64_t(solver.body().size());
  outcome.bytes = std::remove_cvref_t<decltype(solver.body())>::bytes_per_particle;

  const double unit = std::max(1.0, options.ratio) * std::abs(options.vertical);
  outcome.error = detail::stress_error(solver.body(), kirsch, 3 * hole) / unit;
  const double window = std::min(.5, 2 / options.cells) * hole;
  const auto wall = analysis::fit_wall(Samples(solver.body(), 0, hole + window), hole, window).hoop;
  outcome.wall_0 = (wall.mean + wall.cos2 - kirsch.polar_stress(hole, 0).tt) / unit;
  outcome.wall_90 = (wall.mean - wall.cos2 - kirsch.polar_stress(hole, std::numbers::pi / 2).tt) / unit;
  return outcome;
}

}  // namespace mpm::problems
