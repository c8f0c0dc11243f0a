// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/detonation.hpp>
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
#include <problems/outcome.hpp>
#include <cmath>
#include <vector>

namespace mpm::problems {

/// PETN of 1260 kg/m3 lit at a rigid wall at x = 0, one metre of it, until the front has come to .9 m.
struct PlaneDetonationOptions {
  int cells = 100;     ///< in one metre
  int per_edge = 4;    ///< particles a cell
  double safety = .5;  ///< share of the stable step
  BulkViscosity viscosity{};
};

/// A particle of the charge at the end of the run.
struct Product {
  double x, pressure, volume;  ///< m, Pa, m
};

/// Runs the charge with its programmed burn, and returns the particles and the times at which they first had half the
/// CJ pressure, in `arrival`.
template <class Shape, class Integrator, class Scalar = double>
Outcome plane_detonation(const PlaneDetonationOptions& options, Integrator integrator = {},
                         std::vector<Product>* products = nullptr) {
  using S = Uniaxial<Scalar>;
  JonesWilkinsLee law = petn_1260().with_own_detonation();
  law.viscosity = options.viscosity;
  const analysis::TaylorWave exact(law);
  const double h = 1. / options.cells, D = exact.front().velocity, end = .98 / D;
  Body<Shape, JonesWilkinsLee, S> charge{"charge", {}, law};
  fill(charge, Vector<S>{Scalar(0)}, Vector<S>{Scalar(1)}, Scalar(h / options.per_edge));
  for (std::size_t p = 0; p < charge.size(); ++p) {
    auto state = charge.state(p);
    state.lighting_time = Scalar(double(charge.x(0)[p]) / D);
    charge.store(p, state);
  }
  Solver<Shape, JonesWilkinsLee, Integrator, S> solver{Grid<S>{Vector<S>{Scalar(0)}, Scalar(h), {options.cells}},
                                                       std::move(charge)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  for (const int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};
  const double start = processor_seconds();
  solver.run(end);
  const double seconds = processor_seconds() - start;
  const auto& body = solver.body();
  double difference = 0, whole = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const double x = double(body.x(0)[p]), V = double(body.volume()[p]), p_exact = exact.at(x / .98).pressure;
    difference += V * std::abs(double(body.state(p).pressure) - p_exact);
    whole += V * p_exact;
#ifdef DUMP
    std::printf("D %g %g %g %g %g %g %g\n", x/.98, body.state(p).pressure, p_exact, body.v(0)[p], exact.at(x/.98).velocity, law.density*body.volume()[p]/body.mass()[p], law.density/exact.at(x/.98).density);
#endif
  }
  return {difference / whole, std::int64_t(body.size()), solver.steps, seconds, body.bytes_per_particle};
}

}  // namespace mpm::problems
