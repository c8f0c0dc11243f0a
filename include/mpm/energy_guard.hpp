// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/energy.hpp>
#include <mpm/error.hpp>
#include <mpm/relax.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <type_traits>

namespace mpm {

/// Watches a run for energy that comes from nowhere: kinetic energy and stress work, less the work of the faces and of
/// a uniform body force, stay what they were but for what the scheme loses (USL, PIC) or gains by a few per cent (USF),
/// of any law. A method beyond its limits makes as much as there is.
///
/// Called after a step, `solver.run(end, [&](auto& s) { guard(s); })`, it looks every `interval` steps. Set it anew,
/// `guard = {}`, when particles or the body force were changed between steps.
struct EnergyGuard {
  double tolerance = 0.5;  ///< growth that is allowed, of the largest kinetic energy so far
  int interval = 20;       ///< steps between two looks

  /// Throws Error, naming the fastest particle of the body with most kinetic energy, once energy has grown too far.
  template <class SolverT>
  void operator()(SolverT& solver) {
    using Force = std::remove_cvref_t<decltype(solver.body_force)>;
    using S = typename std::remove_cvref_t<decltype(solver.body())>::SpaceType;
    static_assert(std::is_same_v<Force, UniformBodyForce<S>>,
                  "mpm::EnergyGuard: the work of a body force of one's own is not known; leave the guard out");
    if (watched_ && solver.steps % interval != 0) return;
    double kinetic = 0, other = -solver.boundary.work();
    solver.for_bodies([&](const auto& body) {
      kinetic += kinetic_energy(body);
      other += body.stress_work - height(body, solver.body_force);
    });
    if (!watched_) {
      start_ = kinetic + other, watched_ = true;
      largest_ = 1e-6 * detail::elastic_energy_scale(solver);  // what stirs in a body at rest is round-off
    }
    largest_ = std::max(largest_, kinetic);
    const double growth = kinetic + other - start_, round_off = 1e-12 * (std::abs(start_) + std::abs(other));
    if (growth > tolerance * largest_ + round_off) fail(solver, growth);
  }

 private:
  /// sum m b.x: what the body force has done on a body, but for a constant.
  template <class Body, class Force>
  static double height(const Body& body, const Force& force) {
    const auto b = force(body, 0, 0);
    double sum = 0;
    if (!b.isZero(0))
      for (std::size_t p = 0; p < body.size(); ++p) sum += double(body.mass()[p] * b.dot(body.position(p)));
    return sum;
  }
  template <class SolverT>
  [[noreturn]] void fail(SolverT& solver, double growth) const {
    double most = 0;
    solver.for_bodies([&](const auto& body) { most = std::max(most, kinetic_energy(body)); });
    std::ostringstream text;
    solver.for_bodies([&](const auto& body) {
      if (kinetic_energy(body) < most || text.tellp() > 0) return;
      std::size_t fastest = 0;
      for (std::size_t p = 1; p < body.size(); ++p)
        if (body.velocity(p).squaredNorm() > body.velocity(fastest).squaredNorm()) fastest = p;
      text << "particle " << fastest << " of " << body.name << " at (";
      for (int d = 0; d < body.dimension; ++d) text << (d ? ", " : "") << body.x(d)[fastest];
      text << ") m moves at " << body.velocity(fastest).norm() << " m/s and is the fastest of a run that has gained "
           << growth << " J that no face, body force or stress explains (" << tolerance
           << " of its largest kinetic energy is allowed), in step " << solver.steps << " at " << solver.time
           << " s: lower `safety`, let points be finer (more particles a cell), or take mpm::Cpdi or mpm::Cpgimp where "
              "it is stretched";
    });
    throw Error(text.str());
  }

  bool watched_ = false;
  double start_ = 0, largest_ = 0;
};

}  // namespace mpm
