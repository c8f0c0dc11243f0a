// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/energy.hpp>
#include <mpm/mpm.hpp>
#include <problems/outcome.hpp>
#include <problems/strain_energy.hpp>
#include <algorithm>
#include <cmath>

namespace mpm::problems {

/// A rubber beam of 4 x 1 m, clamped at one end, falls under its own weight from rest (Sadeghirad, Brannon & Burghardt
/// 2011, Int. J. Numer. Methods Eng. 86, 1435): E 1 MPa, nu .3, 1050 kg/m3, plane strain, 3 s.
///
/// The clamp is a wall, which at 10 m/s2 the end touches after its lowest point; at 5 m/s2 it does not.
struct CantileverOptions {
  int cells = 8;               ///< over the height of the beam
  int per_edge = 2;            ///< particles a cell edge
  double safety = .5;          ///< share of the stable step
  double end = 3;              ///< s
  double gravity = 10;         ///< m/s2
  double deflection = 3.7966;  ///< the largest of the tip, known otherwise, m
};

/// How the beam swung.
struct CantileverRecord {
  double deflection = 0;     ///< largest of the tip, m
  double period = 0;         ///< s: when the tip passes half way down plus when it passes there again, since a swing is
                             ///< the same forth and back and higher modes blur the time of the highest point
  double energy_change = 0;  ///< of kinetic energy, strain energy and that of the weight, from the start to the tip's
                             ///< highest point on its return, in the largest strain energy
  double energy_ripple = 0;  ///< largest of that change on the way
};

namespace detail {

/// Total energy of a body under gravity, J.
template <class Body>
double energy_under(double g, const Body& body) {
  double height = 0;
  for (std::size_t p = 0; p < body.size(); ++p) height += double(body.mass()[p]) * double(body.x(1)[p]);
  return kinetic_energy(body) + strain_energy(body) + g * height;
}
/// Height of the end of the beam: half a particle's length beyond the centres of the last ones.
template <class Body>
double end_height(const Body& tip, double spacing) {
  double sum = 0;
  for (std::size_t p = 0; p < tip.size(); ++p) sum += double(tip.x(1)[p]) + double(tip.F(p).yx) * spacing / 2;
  return sum / double(tip.size());
}

}  // namespace detail

/// No exact solution exists: the error is that of the largest deflection of the end's middle against
/// `options.deflection`. The last two particles at mid height are a body of their own, since a body reorders its
/// particles.
template <class Shape, class Integrator, class Scalar = double>
Outcome cantilever(const CantileverOptions& options, Integrator integrator = {}, CantileverRecord* record = nullptr) {
  using S = PlaneStrain<Scalar>;
  constexpr double length = 4;
  const double h = 1. / options.cells, spacing = h / options.per_edge;
  const double g = options.gravity, half_way = options.deflection / 2;
  const auto at_tip = [=](const auto& x) {
    return double(x[0]) > length - spacing && std::abs(double(x[1]) - .5) < spacing;
  };
  const auto part = [&](const char* name, bool tip) {
    Body<Shape, NeoHookean, S> body{name, {}, {.density = 1050, .young = 1e6, .poisson = .3}};
    fill(body, Vector<S>{0, 0}, Vector<S>{Scalar(length), 1}, Scalar(spacing),
         [=](const auto& x) { return at_tip(x) == tip; });
    return body;
  };
  constexpr double below = 4, above = 2, beyond = 1;  // m of grid around the beam
  const auto count = [&](double metres) { return int(std::lround(metres / h)); };
  const Grid<S> grid{Vector<S>{0, Scalar(-below)}, Scalar(h), {count(length + beyond), count(below + above)}};
  Solver<Shape, PerBody<NeoHookean, NeoHookean>, Integrator, S> solver{grid, part("beam", false), part("tip", true)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  solver.boundary.face(0, 0) = Fixed<S>{};
  solver.body_force[1] = Scalar(-g);
  const auto &beam = solver.body(), &tip = solver.template body<1>();
  const auto energy = [&] { return detail::energy_under(g, beam) + detail::energy_under(g, tip); };

  CantileverRecord swing;
  const double first_energy = energy();
  double highest = -1e300, largest_strain = 0, before = 0, time_before = 0, seconds = 0;
  int passes = 0;
  while (solver.time < options.end) {
    const double start = processor_seconds();
    solver.step(options.end - solver.time);
    seconds += processor_seconds() - start;
    const double height = detail::end_height(tip, spacing) - .5, change = energy() - first_energy;
    largest_strain = std::max(largest_strain, strain_energy(beam) + strain_energy(tip));
    swing.energy_ripple = std::max(swing.energy_ripple, std::abs(change));
    if (-height > swing.deflection) swing.deflection = -height, highest = -1e300;
    if (height > highest) highest = height, swing.energy_change = change;
    if ((height + half_way) * (before + half_way) < 0 && passes < 2) {
      const double share = (before + half_way) / (before - height);
      swing.period += time_before + share * (solver.time - time_before), ++passes;
    }
    before = height, time_before = solver.time;
  }
  swing.energy_change /= largest_strain;
  swing.energy_ripple /= largest_strain;
  if (record) *record = swing;
  return {std::abs(swing.deflection / options.deflection - 1), std::int64_t(beam.size() + tip.size()), solver.steps,
          seconds, beam.bytes_per_particle};
}

}  // namespace mpm::problems
