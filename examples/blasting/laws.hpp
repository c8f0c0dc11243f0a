// SPDX-License-Identifier: MIT
#pragma once
#include "scene.hpp"
#include <mpm/materials/presets.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

// From the scene's keys to constitutive laws, and what the stages need to know of each rock.
namespace blasting {

using CrackingRock = mpm::WithTensileLaw<mpm::JohnsonHolmquist2>;
using CrushingRock = mpm::JohnsonHolmquist2;
using ElasticRock = mpm::Hypoelastic;

/// The rock of the scene: a preset, its constants replaced by the keys that are set.
template <class Rock>
Rock rock_law(const Scene& scene);

/// The charge of the scene, burning as it says.
mpm::JonesWilkinsLee charge_law(const Scene& scene);
/// The air of the scene.
mpm::PolynomialEos air_law(const Scene& scene);

/// Largest tensile strength, Pa, at which a particle of the scene softens without snap-back (see RankineSoftening).
double largest_tensile_strength(const Scene& scene);

/// Throws mpm::io::InputError if the scene's constants make no rock: a mean tensile strength above
/// `largest_tensile_strength`, or an equation of state that cannot carry the in-situ stress.
void check_laws(const Scene& scene);

/// Relative volume of rock at rest under the mean pressure p, Pa: the inverse of its equation of state.
inline double relative_volume(const mpm::JohnsonHolmquist2& rock, double p) {
  return rock.relative_volume(p);
}
inline double relative_volume(const ElasticRock&, double) {
  return 1;
}

/// State of uncracked rock at rest under `stress`.
inline auto state_under(const CrackingRock& rock, const mpm::SymmetricTensor<double>& stress) {
  return rock.state_of(stress);
}
template <class Rock>
auto state_under(const Rock&, const mpm::SymmetricTensor<double>& stress) {
  typename Rock::template State<double> state{};
  state.stress = stress;
  return state;
}

/// Damage by crushing and by cracking, each 0 to 1; an elastic rock has none.
struct Damage {
  double crushed = 0, cracked = 0;
  double larger() const { return std::max(crushed, cracked); }
};
template <class State>
Damage damage_of(const State& state) {
  Damage d;
  if constexpr (requires { state.damage; }) d.crushed = state.damage;
  if constexpr (requires { state.cracking; }) d.cracked = state.cracking;
  return d;
}

/// Gives every particle its tensile strength, Weibull about the scene's mean by its seed, capped at the largest that
/// does not snap back. Returns how many were capped. A rock without a tensile law is left alone.
template <class Body>
std::size_t scatter_strength(Body& body, const Scene& scene) {
  std::size_t capped = 0;
  if constexpr (requires { body.state(0).strength; }) {
    const double modulus = scene.rock.tensile.weibull_modulus;
    if (modulus == 0) return 0;
    const double largest = largest_tensile_strength(scene);
    const double scale = scene.rock.tensile.strength / std::tgamma(1 + 1 / modulus);
    std::mt19937_64 random(static_cast<std::uint64_t>(scene.seed));
    for (std::size_t p = 0; p < body.size(); ++p) {
      const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;  // in (0, 1), the same on every platform
      auto state = body.state(p);
      state.strength = scale * std::pow(-std::log(u), 1 / modulus);
      if (state.strength > largest) state.strength = largest, ++capped;
      body.store(p, state);
    }
  }
  return capped;
}

}  // namespace blasting
