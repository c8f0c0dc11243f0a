// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/bar.hpp>
#include <mpm/analysis/energy.hpp>
#include <mpm/mpm.hpp>
#include <problems/outcome.hpp>
#include <algorithm>
#include <cmath>

namespace mpm::problems {

/// A bar of 25 m, fixed at one end and free at the other, swinging in its lowest mode (Bardenhagen 2002, J. Comput.
/// Phys. 180, 383, for what the stress update does to its energy).
struct AxialBarOptions {
  int cells = 25;       ///< in the bar's length
  int per_edge = 2;     ///< particles a cell
  double safety = .5;   ///< share of the stable step
  double periods = 10;  ///< of the run
};

/// How the bar swung.
struct AxialBarRecord {
  double energy_drift = 0;   ///< mean energy (kinetic and stress work) over the last period less that over the first,
                             ///< in the exact one: velocity and stress stand half a step apart, so it ripples within
  double energy_ripple = 0;  ///< largest distance from the exact energy within the first period, in that energy
  double period = 0;         ///< mean, from the zeros of the mean displacement, in exact periods
};

/// The error is that of the displacement at the end, sqrt(sum (u - u_exact)^2 / N) in the exact amplitude of the free
/// end. The bar is let go at rest in displacement with its full speed; cross-section 1 m2.
template <class Shape, class Integrator, class Scalar = double>
Outcome axial_bar(const AxialBarOptions& options, Integrator integrator = {}, AxialBarRecord* record = nullptr) {
  using S = Uniaxial<Scalar>;
  const analysis::AxialBar exact{};
  const double h = exact.length / options.cells, spacing = h / options.per_edge;
  Body<Shape, Hypoelastic, S> bar{"bar", {}, {.density = exact.density, .young = exact.young, .poisson = 0}};
  fill(bar, Vector<S>{Scalar(0)}, Vector<S>{Scalar(exact.length)}, Scalar(spacing));
  for (std::size_t p = 0; p < bar.size(); ++p) bar.v(0)[p] = Scalar(exact.velocity(double(bar.x(0)[p]), 0));
  Solver<Shape, Hypoelastic, Integrator, S> solver{Grid<S>{Vector<S>{Scalar(0)}, Scalar(h), {options.cells + 2}},
                                                   std::move(bar)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  solver.boundary.face(0, 0) = Rollers<S>{};
  const auto& body = solver.body();
  const auto X = [&](std::size_t p) { return spacing * (double(p) + .5); };  // in one dimension they keep their order

  AxialBarRecord swing;
  const double T = exact.period(), end = options.periods * T;
  double before = 0, time_before = 0, first = -1, last = 0, seconds = 0;
  int zeros = 0;
  while (solver.time < end) {
    const double start = processor_seconds();
    const double dt = double(solver.step(end - solver.time));
    seconds += processor_seconds() - start;
    double mean = 0;
    for (std::size_t p = 0; p < body.size(); ++p) mean += double(body.x(0)[p]) - X(p);
    if (before * mean < 0) {
      last = time_before + (solver.time - time_before) * before / (before - mean);
      if (first < 0) first = last;
      ++zeros;
    }
    before = mean, time_before = solver.time;
    const double energy = (kinetic_energy(body) + body.stress_work) / exact.energy() - 1;
    if (solver.time <= T) {
      swing.energy_drift -= energy * dt / T;
      swing.energy_ripple = std::max(swing.energy_ripple, std::abs(energy));
    }
    if (solver.time > end - T) swing.energy_drift += energy * dt / T;
  }
  swing.period = zeros > 1 ? 2 * (last - first) / (zeros - 1) / T : 0;
  if (record) *record = swing;

  double difference = 0;
  const double amplitude = exact.displacement(exact.length, T / 4);
  for (std::size_t p = 0; p < body.size(); ++p)
    difference += std::pow(double(body.x(0)[p]) - X(p) - exact.displacement(X(p), solver.time), 2);
  return {std::sqrt(difference / double(body.size())) / amplitude, std::int64_t(body.size()), solver.steps, seconds,
          body.bytes_per_particle};
}

}  // namespace mpm::problems
