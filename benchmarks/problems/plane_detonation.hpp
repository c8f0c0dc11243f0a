// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/detonation.hpp>
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
#include <problems/outcome.hpp>
#include <algorithm>
#include <cmath>
#include <vector>

namespace mpm::problems {

/// A metre of PETN of 1260 kg/m3, lit at a rigid wall at x = 0, its burn programmed.
struct PlaneDetonationOptions {
  int cells = 100;        ///< in one metre
  int per_edge = 4;       ///< particles a cell
  double safety = .5;     ///< share of the stable step
  double distance = .98;  ///< the exact front's at the end of the run, m
  BulkViscosity viscosity{};
};

/// A particle of the charge at the end.
struct BurnedParticle {
  double position;  ///< x/(D t)
  double pressure;  ///< Pa
  double exact;     ///< that of the Taylor wave there, Pa
};

/// The error is that of the pressure in the relative L1 norm over the particles, burn zone included. Appends the
/// particles, in the order of their positions, to `profile` if there is one.
template <class Shape, class Integrator, class Scalar = double>
Outcome plane_detonation(const PlaneDetonationOptions& options, Integrator integrator = {},
                         std::vector<BurnedParticle>* profile = nullptr) {
  using S = Uniaxial<Scalar>;
  JonesWilkinsLee law = petn_1260().with_own_detonation();
  law.viscosity = options.viscosity;
  const analysis::TaylorWave exact(law);
  const double h = 1. / options.cells, D = exact.front().velocity;
  Body<Shape, JonesWilkinsLee, S> charge{"charge", {}, law};
  fill(charge, Vector<S>{Scalar(0)}, Vector<S>{Scalar(1)}, Scalar(h / options.per_edge));
  for (std::size_t p = 0; p < charge.size(); ++p) {
    auto state = charge.state(p);
    state.lighting_time = charge.x(0)[p] / Scalar(D);
    charge.store(p, state);
  }
  Solver<Shape, JonesWilkinsLee, Integrator, S> solver{Grid<S>{Vector<S>{Scalar(0)}, Scalar(h), {options.cells}},
                                                       std::move(charge)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  for (const int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};

  const double start = processor_seconds();
  solver.run(options.distance / D);
  const double seconds = processor_seconds() - start;

  const auto& body = solver.body();
  double difference = 0, whole = 0;
  std::vector<BurnedParticle> burned;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const double V = double(body.volume()[p]), position = double(body.x(0)[p]) / options.distance;
    burned.push_back({position, double(body.state(p).pressure), exact.at(position).pressure});
    difference += V * std::abs(burned.back().pressure - burned.back().exact);
    whole += V * burned.back().exact;
  }
  std::sort(burned.begin(), burned.end(), [](const auto& a, const auto& b) { return a.position < b.position; });
  if (profile) profile->insert(profile->end(), burned.begin(), burned.end());
  return {difference / whole, std::int64_t(body.size()), solver.steps, seconds, body.bytes_per_particle};
}

}  // namespace mpm::problems
