// SPDX-License-Identifier: MIT
#pragma once
#include "cavity.hpp"

// The hole of the cavity with a charge in it: PETN that has burned at constant volume, of three quarters of the hole's
// radius, in elastic rock.
namespace mpm::problems {

struct ChargedHoleOptions {
  double cells = 4;      ///< cells on a radius of the hole
  int per_edge = 2;      ///< rock particles an edge of a cell
  int gas_per_edge = 4;  ///< gas particles an edge of a cell
  bool air = true;       ///< between charge and rock, or nothing
  double safety = .5;    ///< share of the stable step
  double side = 15;      ///< half side of the block, radii
  double end = 80e-6;    ///< s
};

/// What the rock felt.
struct ChargedHoleOutcome : Outcome {  // error: not set, as no exact solution exists
  static constexpr std::array radii{2.0, 5.0};
  std::array<double, 2> peak{};  ///< peak hoop stress at these radii, Pa

  /// The larger of the errors against another run's peaks.
  double error_against(const ChargedHoleOutcome& other) const {
    double worst = 0;
    for (std::size_t i = 0; i < peak.size(); ++i) worst = std::max(worst, std::abs(peak[i] / other.peak[i] - 1));
    return worst;
  }
};

namespace detail {

constexpr double charge_radius = .75 * hole;

/// Puts gas on a lattice wherever `inside(x)`, in the quarter or the ray of the hole, and scales it to its true
/// cross-section, a quarter's or a radian's, which a lattice meets only nearly.
template <class S, class Law>
Body<Ugimp, Law, S> gas(const char* name, const Law& law, double spacing, double inner, double outer) {
  Body<Ugimp, Law, S> body(name, {}, law);
  const double extent = std::ceil(outer / spacing - 1e-9) * spacing;
  fill(body, Vector<S>::Zero(), Vector<S>::Constant(extent), spacing,
       [&](const Vector<S>& x) { return x.norm() >= inner && x.norm() < outer; });
  double sum = 0;
  for (std::size_t p = 0; p < body.size(); ++p) sum += body.volume()[p];
  const double area = (S::hoop ? .5 : std::numbers::pi / 4) * (outer * outer - inner * inner);
  for (std::size_t p = 0; p < body.size(); ++p) body.volume()[p] *= area / sum, body.mass()[p] *= area / sum;
  return body;
}

/// Rock, charge and air, step by step.
template <class S, class RockShape>
ChargedHoleOutcome detonate(const ChargedHoleOptions& options, const Grid<S>& grid,
                            Body<RockShape, Hypoelastic, S> rock) {
  const double cell = hole / options.cells, spacing = cell / options.gas_per_edge;
  Body<Ugimp, PolynomialEos, S> gap("air", {}, air());
  if (options.air) gap = gas<S>("air", air(), spacing, charge_radius, hole);
  Solver<PerBody<RockShape, Ugimp, Ugimp>, PerBody<Hypoelastic, JonesWilkinsLee, PolynomialEos>, Musl, S> solver(
      grid, std::move(rock), gas<S>("charge", petn_1260(), spacing, 0, charge_radius), std::move(gap));
  solver.safety = options.safety;
  for (int d = 0; d < S::dimension; ++d) solver.boundary.face(d, 0) = Rollers<S>{};
  ChargedHoleOutcome outcome;
  while (solver.time < options.end) {
    const double start = processor_seconds();
    solver.step(options.end - solver.time);
    outcome.seconds += processor_seconds() - start;
    for (std::size_t i = 0; i < outcome.radii.size(); ++i)
      outcome.peak[i] = std::max(outcome.peak[i], hoop_stress(solver.body(), outcome.radii[i] * hole, cell));
  }
  solver.for_bodies([&](const auto& body) { outcome.particles += std::int64_t(body.size()); });
  outcome.steps = solver.steps;
  outcome.bytes = std::remove_cvref_t<decltype(solver.body())>::bytes_per_particle;
  return outcome;
}

}  // namespace detail

/// A quarter of the plane, the rock on quadrilaterals. Throws Error as Solver::step.
inline ChargedHoleOutcome charged_hole(const ChargedHoleOptions& options) {
  const auto mesh = holed_block(options.side, options.cells, options.per_edge).mesh();
  return detail::detonate<PlaneStrain<>>(options, holed_block_grid(options.side, options.cells),
                                         geometry::make_body("rock", mesh, granite_elastic()));
}

/// Along the radius, from the axis. Charge and hole end on particles where gas_per_edge times cells is a multiple of 4.
inline ChargedHoleOutcome radial_charged_hole(const ChargedHoleOptions& options) {
  using S = Radial<>;
  const double cell = hole / options.cells;
  Body<Ugimp, Hypoelastic, S> rock("rock", {}, granite_elastic());
  fill(rock, Vector<S>(hole), Vector<S>(options.side * hole), cell / options.per_edge);
  const Grid<S> grid(Vector<S>(0.), cell, {int(std::lround((options.side + .5) * options.cells))});  // it expands
  return detail::detonate<S>(options, grid, std::move(rock));
}

}  // namespace mpm::problems
