// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/energy.hpp>
#include <mpm/mpm.hpp>
#include <problems/outcome.hpp>
#include <problems/strain_energy.hpp>
#include <algorithm>
#include <cmath>

namespace mpm::problems {

/// Two rubber discs in the unit box meet and bounce (Sulsky, Chen & Schreyer 1994, Comput. Methods Appl. Mech. Eng.
/// 118, 179): radius .2 m, E 1 kPa, nu .3, 1000 kg/m3, 0.1 m/s along each axis.
struct CollidingDiscsOptions {
  int cells = 20;      ///< along the box
  int per_edge = 2;    ///< particles a cell edge
  double safety = .5;  ///< share of the stable step
  double end = 2.8;    ///< s; the discs have parted by 2.4
};

/// What the collision did.
struct CollidingDiscsRecord {
  double momentum = 0;       ///< change of the total, in the momentum of one disc
  double energy_change = 0;  ///< of kinetic and strain energy at the end, in the first kinetic energy
  double energy_low = 0;     ///< smallest and largest of that change on the way
  double energy_high = 0;
  double least_kinetic = 1;  ///< share of the kinetic energy that is left when the discs are pressed most
  double rebound = 0;        ///< momentum of the first disc at the end, in what it had, along its first direction
};

/// No exact solution exists; the error is the energy's change at the end, in the first kinetic energy.
template <class Shape, class Integrator, class Scalar = double>
Outcome colliding_discs(const CollidingDiscsOptions& options, Integrator integrator = {},
                        CollidingDiscsRecord* record = nullptr) {
  using S = PlaneStrain<Scalar>;
  const double h = 1. / options.cells, v = .1;
  const NeoHookean rubber{.density = 1000, .young = 1000, .poisson = .3};
  const auto disc = [&](const char* name, double centre, double speed) {
    Body<Shape, NeoHookean, S> body{name, {}, rubber};
    const auto inside = [=](const auto& at) { return std::hypot(double(at[0]) - centre, double(at[1]) - centre) < .2; };
    fill(body, Vector<S>{0, 0}, Vector<S>{1, 1}, Scalar(h / options.per_edge), inside,
         Vector<S>{Scalar(speed), Scalar(speed)});
    return body;
  };
  Solver<Shape, PerBody<NeoHookean, NeoHookean>, Integrator, S> solver{
      Grid<S>{Vector<S>{0, 0}, Scalar(h), {options.cells, options.cells}}, disc("first", .3, v),
      disc("second", .7, -v)};
  solver.integrator = integrator;
  solver.safety = Scalar(options.safety);
  const auto &first = solver.body(), &second = solver.template body<1>();

  CollidingDiscsRecord collision;
  const double kinetic = kinetic_energy(first) + kinetic_energy(second), before = double(momentum(first)[0]);
  double seconds = 0;
  while (solver.time < options.end) {
    const double start = processor_seconds();
    solver.step(options.end - solver.time);
    seconds += processor_seconds() - start;
    const double now = kinetic_energy(first) + kinetic_energy(second);
    collision.energy_change = (now + strain_energy(first) + strain_energy(second)) / kinetic - 1;
    collision.energy_low = std::min(collision.energy_low, collision.energy_change);
    collision.energy_high = std::max(collision.energy_high, collision.energy_change);
    collision.least_kinetic = std::min(collision.least_kinetic, now / kinetic);
  }
  const Vector<S> total = momentum(first) + momentum(second);
  collision.momentum = double(total.norm()) / before;
  collision.rebound = double(momentum(first)[0]) / before;
  if (record) *record = collision;
  return {std::abs(collision.energy_change), std::int64_t(first.size() + second.size()), solver.steps, seconds,
          first.bytes_per_particle};
}

}  // namespace mpm::problems
