// SPDX-License-Identifier: MIT
#pragma once
#include "holed_rock.hpp"
#include "outcome.hpp"
#include <mpm/analysis/blast_cavity.hpp>
#include <map>
#include <type_traits>
#include <utility>

// Linear elastic rock under Blair's pulse as a pressure on the wall of its hole, against the exact solution in the
// Laplace domain.
namespace mpm::problems {

struct CavityOptions {
  double cells = 4;                ///< cells on a radius a of the hole
  int per_edge = 2;                ///< particles an edge of a cell
  double safety = .8;              ///< share of the stable step
  double side = 15;                ///< half side of the block, radii
  double end = 80e-6;              ///< s; what free faces at 15 a send back reaches 10 a after 87 us
  double history_from = 0;         ///< s, where the comparison of histories begins
  Model model = Model::quarter;    ///< in the plane
  std::array<double, 2> offset{};  ///< of the hole from a node, cells; full model only
};

/// Errors are relative to the exact peak of the hoop stress at the same radius.
struct CavityOutcome : Outcome {  // error: largest of abs(peak)
  static constexpr std::array radii{2.0, 5.0, 10.0};
  std::array<double, 3> peak{};  ///< of the peak hoop stress at these radii, signed
  double history = 0;            ///< largest of the hoop stress over the history at 5 a
  double wall = 0;               ///< of the peak hoop stress on the wall, signed; read where particle edges make it
};

/// Blair's pulse on the paper's hole in the paper's rock, weak enough that the geometry stays that of the exact
/// solution: 1 MPa.
inline analysis::BlastCavity blast_cavity() {
  const auto rock = granite_elastic();
  return {.young = rock.young,
          .poisson = rock.poisson,
          .density = rock.density,
          .radius = hole,
          .load = {.peak = 1e6, .n = 2, .gamma = 1e5}};
}

namespace detail {

/// The exact peak of the hoop stress until `end`, Pa; searched once, which takes longer than a coarse run.
inline double exact_peak(double radius, double end) {
  static std::map<std::pair<double, double>, double> known;
  const auto [at, is_new] = known.try_emplace({radius, end});
  if (is_new) at->second = blast_cavity().peaks(radius, end).hoop.value;
  return at->second;
}

/// The hoop stress on a ring, over the particles within a cell of it.
template <class Body>
double hoop_stress(const Body& body, double r, double cell, std::array<double, 2> centre = {}) {
  return analysis::fit_ring(Samples(body, r - cell, r + cell, centre), r, cell).tt;
}

/// Peaks and history of the hoop stress, read after every step.
class HoopReader {
 public:
  HoopReader(const CavityOptions& options, std::array<double, 2> centre)
      : centre_(centre), cell_(hole / options.cells), history_from_(options.history_from), end_(options.end) {
    for (std::size_t i = 0; i < exact_.size(); ++i) exact_[i] = exact_peak(CavityOutcome::radii[i] * hole, end_);
  }
  template <class SolverT>
  void read(SolverT& solver) {
    const auto& body = solver.body();
    for (std::size_t i = 0; i < exact_.size(); ++i) {
      const double r = CavityOutcome::radii[i] * hole, hoop = hoop_stress(body, r, cell_, centre_);
      highest_[i] = std::max(highest_[i], hoop);
      if (i == 1 && solver.time >= history_from_)
        history_ = std::max(history_, std::abs(hoop - cavity_.at(r, solver.time).tt));
    }
    // In the radial space both particles of a cell have its one strain: a stair, which no fit can follow to the wall.
    using Shape = typename std::remove_cvref_t<decltype(body)>::Shape;
    if constexpr (std::is_same_v<Shape, CpdiQuad>) wall_ = std::max(wall_, wall(body));
  }
  void report(CavityOutcome& outcome) const {
    for (std::size_t i = 0; i < exact_.size(); ++i) {
      outcome.peak[i] = highest_[i] / exact_[i] - 1;
      outcome.error = std::max(outcome.error, std::abs(outcome.peak[i]));
    }
    outcome.history = history_ / exact_[1];
    if (wall_ > 0) outcome.wall = wall_ / exact_peak(hole, end_) - 1;
  }

 private:
  template <class Body>
  double wall(const Body& body) const {
    const double window = std::min(.5 * hole, 2 * cell_);
    return analysis::fit_wall(Samples(body, 0, hole + window, centre_), hole, window).hoop.mean;
  }

  analysis::BlastCavity cavity_ = blast_cavity();
  std::array<double, 2> centre_;
  double cell_, history_from_, end_, history_ = 0, wall_ = 0;
  std::array<double, 3> exact_{}, highest_{};
};

/// Steps to the end; `press(p)` puts the pressure on the wall.
template <class SolverT, class Press>
CavityOutcome blast(SolverT& solver, const CavityOptions& options, std::array<double, 2> centre, const Press& press) {
  const analysis::BlairLoad load = blast_cavity().load;
  HoopReader reader(options, centre);
  CavityOutcome outcome;
  solver.safety = typename SolverT::Scalar(options.safety);
  double dt = 0;
  while (solver.time < options.end) {
    // Forces act at the time level of the stress: the step's start, or its end where the stress is updated first.
    press(load.pressure(solver.time + (SolverT::stress_update == StressUpdate::first ? dt : 0)));
    const double start = processor_seconds();
    dt = double(solver.step(options.end - solver.time));
    outcome.seconds += processor_seconds() - start;
    reader.read(solver);
  }
  reader.report(outcome);
  outcome.particles = std::int64_t(solver.body().size());
  outcome.steps = solver.steps;
  outcome.bytes = std::remove_cvref_t<decltype(solver.body())>::bytes_per_particle;
  return outcome;
}

}  // namespace detail

/// The cavity in the plane, on quadrilaterals whose edges make the wall. `prepare(solver)` may change what is free, the
/// outer faces. Throws Error as Solver::step.
template <class Shape = CpdiQuad, class Integrator = Usl, class Scalar = double, class Prepare>
CavityOutcome cavity(const CavityOptions& options, const Integrator& integrator, const Prepare& prepare) {
  static_assert(std::is_same_v<Shape, CpdiQuad>, "problems::cavity: particle edges make the wall; see radial_cavity");
  using Space = PlaneStrain<Scalar>;
  auto block = holed_block(options.side, options.cells, options.per_edge, options.model);
  for (int d = 0; d < 2; ++d) block.centres[0][d] = options.offset[d] * hole / options.cells;
  Solver<Shape, Hypoelastic, Integrator, Space> solver(
      holed_block_grid<Space>(options.side, options.cells, options.model),
      geometry::make_body<Space>("rock", block.mesh(), granite_elastic()));
  solver.integrator = integrator;
  if (options.model == Model::quarter) roll_on_axes(solver);
  prepare(solver);
  return detail::blast(solver, options, block.centres[0], [&](double p) { solver.body().shape.pressure = p; });
}
template <class Shape = CpdiQuad, class Integrator = Usl, class Scalar = double>
CavityOutcome cavity(const CavityOptions& options, const Integrator& integrator = {}) {
  return cavity<Shape, Integrator, Scalar>(options, integrator, [](auto&) {});
}

/// The cavity in one dimension, on a grid that begins at the wall.
template <class Shape, class Integrator = Usl, class Scalar = double>
CavityOutcome radial_cavity(const CavityOptions& options, const Integrator& integrator = {}) {
  using Space = Radial<Scalar>;
  using V = Vector<Space>;
  const double cell = hole / options.cells;
  Body<Shape, Hypoelastic, Space> rock("rock", {}, granite_elastic());
  fill(rock, V(Scalar(hole)), V(Scalar(options.side * hole)), Scalar(cell / options.per_edge));
  Solver<Shape, Hypoelastic, Integrator, Space> solver(
      {V(Scalar(hole)), Scalar(cell), {int(std::lround((options.side - 1) * options.cells))}}, std::move(rock));
  solver.integrator = integrator;
  const auto outward = Traction<Space>::on(solver.grid, 0, 0, [](const V&) { return V(Scalar(1)); });
  solver.boundary.face(0, 0) = outward;
  return detail::blast(solver, options, {},
                       [&](double p) { std::get<Traction<Space>>(solver.boundary.face(0, 0)).scale = Scalar(p); });
}

}  // namespace mpm::problems
