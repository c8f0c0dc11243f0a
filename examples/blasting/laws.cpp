// SPDX-License-Identifier: MIT
#include "laws.hpp"
#include <mpm/io/units.hpp>
#include <cmath>

namespace blasting {
namespace {

CrackingRock preset(RockPreset name) {
  switch (name) {
    case RockPreset::granite_1200:
      return mpm::granite_1200();
    case RockPreset::granite_3000:
      return mpm::granite_3000();
    case RockPreset::paper:
      break;
  }
  return mpm::granite_paper();
}

void replace(double& value, const std::optional<double>& by) {
  if (by) value = *by;
}

}  // namespace

template <>
CrackingRock rock_law<CrackingRock>(const Scene& scene) {
  const auto& r = scene.rock;
  CrackingRock law = preset(r.preset);
  replace(law.density, r.density), replace(law.young, r.young), replace(law.poisson, r.poisson);
  replace(law.A, r.A), replace(law.B, r.B), replace(law.C, r.C), replace(law.M, r.M), replace(law.N, r.N);
  replace(law.tensile_pressure, r.tensile_pressure);
  replace(law.sigma_hel, r.sigma_hel), replace(law.p_hel, r.p_hel), replace(law.beta, r.beta);
  replace(law.D1, r.D1), replace(law.D2, r.D2);
  replace(law.K1, r.K1), replace(law.K2, r.K2), replace(law.K3, r.K3);
  replace(law.smax_fracture, r.max_fracture_strength);
  law.tension = {.strength = r.tensile.strength, .fracture_energy = r.tensile.fracture_energy};
  return law;
}

template <>
CrushingRock rock_law<CrushingRock>(const Scene& scene) {
  return rock_law<CrackingRock>(scene);
}

template <>
ElasticRock rock_law<ElasticRock>(const Scene& scene) {
  const CrushingRock rock = rock_law<CrushingRock>(scene);
  return {.density = rock.density, .young = rock.young, .poisson = rock.poisson};
}

mpm::JonesWilkinsLee charge_law(const Scene& scene) {
  const auto& c = scene.charge;
  auto law = c.preset == ChargePreset::petn_1260 ? mpm::petn_1260() : mpm::petn_as_printed();
  replace(law.density, c.density), replace(law.initial_energy, c.E0), replace(law.omega, c.omega);
  replace(law.A, c.A), replace(law.B, c.B), replace(law.R1, c.R1), replace(law.R2, c.R2);
  if (c.burn == Burn::programmed) {
    const double printed = law.detonation_velocity;
    law = law.with_own_detonation();
    if (c.preset == ChargePreset::petn_as_printed) law.detonation_velocity = printed;
    replace(law.detonation_velocity, c.detonation_velocity);
  }
  return law;
}

mpm::PolynomialEos air_law(const Scene& scene) {
  auto law = mpm::air();
  law.density = scene.air.density;
  law.initial_energy = scene.air.energy;
  return law;
}

double largest_tensile_strength(const Scene& scene) {
  const auto law = rock_law<CrackingRock>(scene);
  return law.tension.largest_strength(law.young_in_tension(), scene.rock.particle);
}

namespace {

/// The largest mean pressure beside the hole: the hoop stress there is at most three times the larger stress.
void check_equation_of_state(const Scene& scene) {
  const auto law = rock_law<CrushingRock>(scene);
  const auto [low, high] = std::minmax(scene.stress.horizontal, scene.stress.vertical);
  try {
    relative_volume(law, (1 + law.poisson) * (3 * high - low) / 3);
  } catch (const std::domain_error&) {
    throw mpm::io::InputError("rock.K1 = " + mpm::io::format_quantity(law.K1, "GPa") +
                              ": with rock.K2 and rock.K3 this equation of state cannot carry the in-situ stress; "
                              "lower stress.horizontal and stress.vertical, or correct the constants");
  }
}

void check_softening(const Scene& scene) {
  const auto law = rock_law<CrackingRock>(scene);
  if (scene.rock.law != RockLaw::jh2 || scene.rock.tensile.law != TensileLaw::rankine) return;
  if (law.tension.strength <= largest_tensile_strength(scene)) return;
  const double size = law.tension.largest_size(law.young_in_tension(), law.tension.strength);
  throw mpm::io::InputError(
      "rock.tensile.fracture_energy = " + mpm::io::format_quantity(law.tension.fracture_energy, "J/m^2") +
      ": rock of rock.particle = " + mpm::io::format_quantity(scene.rock.particle, "mm") +
      " would snap back as it cracks; keep particles below " +
      mpm::io::format_quantity(std::floor(size * 1e4) * 1e-4, "mm") + ", or raise the fracture energy");
}

}  // namespace

void check_laws(const Scene& scene) {
  if (scene.rock.law == RockLaw::jh2) check_equation_of_state(scene);
  check_softening(scene);
}

}  // namespace blasting
