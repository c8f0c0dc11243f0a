// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/riemann.hpp>
#include <mpm/mpm.hpp>
#include <problems/outcome.hpp>
#include <cmath>

namespace mpm::problems {

/// Sod's shock tube (Sod 1978, J. Comput. Phys. 27, 1): the unit tube, its membrane in the middle, at t = .2 s.
struct SodOptions {
  int cells = 200;     ///< of the tube
  int per_edge = 4;    ///< particles a cell
  double safety = .5;  ///< share of the stable step
  BulkViscosity viscosity{};
};

/// The error is that of the density in the relative L1 norm, sum V abs(m/V - rho(x)) / sum V rho(x) over the particles,
/// V the volume that a particle's strains have given it.
///
/// Both gases are one body of evenly spaced particles, which differ eightfold in mass: a particle's box has one size a
/// body, and even masses would leave the thin gas with an eighth of the particles, fewer than one a cell.
template <class Shape, class Integrator, class Scalar = double>
Outcome sod(const SodOptions& options, Integrator integrator = {}) {
  using S = Uniaxial<Scalar>;
  constexpr double membrane = .5, end = .2;
  const analysis::Riemann tube{};
  const double h = 1. / options.cells;
  Body<Shape, PolynomialEos, S> gas{"gas", {}, {.density = tube.left.density, .viscosity = options.viscosity}};
  fill(gas, Vector<S>{Scalar(0)}, Vector<S>{Scalar(1)}, Scalar(h / options.per_edge));
  for (std::size_t p = 0; p < gas.size(); ++p) {
    const auto& side = double(gas.x(0)[p]) < membrane ? tube.left : tube.right;
    gas.mass()[p] *= Scalar(side.density / tube.left.density);
    gas.store(p, {Scalar(side.pressure), Scalar(tube.left.density * side.energy(tube.gamma))});
  }
  Solver<Shape, PolynomialEos, Integrator, S> solver{Grid<S>{Vector<S>{Scalar(0)}, Scalar(h), {options.cells}},
                                                     std::move(gas)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  for (const int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};

  const double start = processor_seconds();
  solver.run(end);
  const double seconds = processor_seconds() - start;

  const auto& body = solver.body();
  double difference = 0, whole = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const double V = double(body.volume()[p]), exact = tube.at((double(body.x(0)[p]) - membrane) / end).density;
    difference += std::abs(double(body.mass()[p]) - V * exact);
    whole += V * exact;
  }
  return {difference / whole, std::int64_t(body.size()), solver.steps, seconds, body.bytes_per_particle};
}

}  // namespace mpm::problems
