// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/noh.hpp>
#include <mpm/mpm.hpp>
#include <problems/outcome.hpp>
#include <algorithm>
#include <cmath>

namespace mpm::problems {

/// Noh's implosion (Noh 1987, J. Comput. Phys. 72, 78) on a wall or an axis at x = 0, gamma 5/3, at t = .6 s: the shock
/// stands at .2 m.
struct NohOptions {
  int cells = 100;     ///< in one metre
  int per_edge = 4;    ///< particles a cell
  double safety = .5;  ///< share of the stable step
  BulkViscosity viscosity{};
  double from = .04, to = .16;  ///< window of the plateau, m: beyond the heated wall, short of the smeared shock
};

/// The error is that of the plateau's mean density, relative, the larger of two readings: the mass in the window over
/// the volumes that strains have given its particles, and over the window's own. In `Uniaxial` the wall, in `Radial`
/// the axis.
template <class Shape, class Integrator, class S = Uniaxial<>>
Outcome noh(const NohOptions& options, Integrator integrator = {}) {
  using Scalar = typename S::Scalar;
  constexpr double end = .6, length = 1;
  const analysis::Noh exact{.dimension = S::hoop ? 2 : 1};
  const double h = 1. / options.cells, cold = 1e-6;  // internal energy; kinetic .5
  PolynomialEos law{.density = 1, .c4 = exact.gamma - 1, .c5 = exact.gamma - 1, .initial_energy = cold};
  law.viscosity = options.viscosity;
  Body<Shape, PolynomialEos, S> gas{"gas", {}, law};
  fill(
      gas, Vector<S>{Scalar(0)}, Vector<S>{Scalar(length)}, Scalar(h / options.per_edge),
      [](const auto&) { return true; }, Vector<S>{Scalar(-exact.speed)});
  Solver<Shape, PolynomialEos, Integrator, S> solver{
      Grid<S>{Vector<S>{Scalar(0)}, Scalar(h), {int(std::lround(length / h)) + 2}}, std::move(gas)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  solver.boundary.face(0, 0) = Rollers<S>{};

  const double start = processor_seconds();
  solver.run(end);
  const double seconds = processor_seconds() - start;

  const auto& body = solver.body();
  double mass = 0, volume = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const double x = double(body.x(0)[p]);
    if (x < options.from || x > options.to) continue;
    mass += double(body.mass()[p]), volume += double(body.volume()[p]);
  }
  const double plateau = exact.at(options.to, end).density, width = options.to - options.from;
  const double window = S::hoop ? width * (options.from + options.to) / 2 : width;
  const auto off = [&](double by) { return std::abs(mass / by / plateau - 1); };
  return {std::max(off(volume), off(window)), std::int64_t(body.size()), solver.steps, seconds,
          body.bytes_per_particle};
}

}  // namespace mpm::problems
