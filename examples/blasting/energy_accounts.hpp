// SPDX-License-Identifier: MIT
#pragma once
#include "scene.hpp"
#include <mpm/analysis/energy.hpp>
#include <mpm/analysis/rock_energy.hpp>
#include <map>
#include <string>

// Where the energy of a blast is.
namespace blasting {

/// Copies of the model that make the full plane.
inline double multiplicity(const Scene& scene) {
  return scene.model == Model::quarter ? 4 : 1;
}

/// Energies of the blast, J per metre of the full plane. What the gas gives, the rock and the faces take: `balance` is
/// what the scheme has gained or lost.
template <class Solver>
std::map<std::string, double> energies(Solver& solver, const Scene& scene, double charge_energy) {
  const double m = multiplicity(scene);
  std::map<std::string, double> e;
  double kinetic = 0, work = 0;
  solver.for_bodies([&](const auto& body) {
    e["kinetic_" + body.name] = m * mpm::kinetic_energy(body);
    e["work_" + body.name] = m * body.stress_work;
    kinetic += m * mpm::kinetic_energy(body), work += m * body.stress_work;
  });
  e["charge"] = charge_energy;
  e["boundary"] = m * solver.boundary.work();
  e["balance"] = kinetic + work - e["boundary"];
  return e;
}

/// Where the charge's energy is, J per metre of the full plane, since the rock was at rest.
struct Ledger {
  double charge = 0;     ///< still in the products
  double air = 0;        ///< internal energy
  double kinetic = 0;    ///< of all bodies
  double elastic = 0;    ///< in the rock
  double fracture = 0;   ///< spent in opening cracks
  double viscosity = 0;  ///< spent by bulk viscosity in the rock
  double crushing = 0;   ///< spent in crushing the rock: the rest of the work done on it
  double boundary = 0;   ///< gone through the outer faces

  double sum() const { return charge + air + kinetic + elastic + fracture + viscosity + crushing + boundary; }
};

/// The ledger of a state; `elastic` and `air` are not yet since the start.
template <class Solver>
Ledger ledger(Solver& solver, const Scene& scene) {
  Ledger sum;
  solver.for_bodies([&](const auto& body) {
    sum.kinetic += mpm::kinetic_energy(body);
    if (body.name == "rock") sum.viscosity = body.viscous_work;
    for (std::size_t p = 0; p < body.size(); ++p) {
      const auto state = body.template state<double>(p);
      const double V0 = body.mass()[p] / body.law.density;
      if constexpr (requires { state.energy; }) {
        (body.name == "charge" ? sum.charge : sum.air) += V0 * state.energy;
      } else {
        sum.elastic += V0 * mpm::analysis::elastic_energy(body.law, state, body.template relative_volume<double>(p));
        sum.fracture += body.volume()[p] *
                        mpm::analysis::fracture_energy_spent(body.law, state, body.template particle_size<double>(p));
      }
    }
  });
  sum.boundary = -solver.boundary.work();
  for (double* value :
       {&sum.charge, &sum.air, &sum.kinetic, &sum.elastic, &sum.fracture, &sum.viscosity, &sum.boundary})
    *value *= multiplicity(scene);
  return sum;
}

}  // namespace blasting
