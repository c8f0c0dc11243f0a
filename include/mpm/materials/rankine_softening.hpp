// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/material.hpp>
#include <mpm/materials/elastic_moduli.hpp>
#include <mpm/materials/principal.hpp>
#include <array>
#include <cmath>

namespace mpm {

/// Tensile strength with linear softening that dissipates a given fracture energy per area of crack, whatever the size
/// of the particle (crack band, Bazant & Oh 1983).
struct RankineSoftening {
  double strength = 54e6;        ///< s_t, Pa; the default of each particle's own
  double fracture_energy = 500;  ///< G_f, J/m2

  /// Largest particle, m, that softens without snap-back: l_c < 2 E G_f/s_t^2. A larger one breaks brittly at s_t and
  /// dissipates more than G_f, so a program should refuse it, or lower its strength to `largest_strength`, and say so.
  double largest_size(double young, double particle_strength) const {
    return 2 * young * fracture_energy / (particle_strength * particle_strength);
  }
  /// Largest strength, Pa, at which a particle of this size, m, softens without snap-back.
  double largest_strength(double young, double size) const { return std::sqrt(2 * young * fracture_energy / size); }

  /// Damage, 0 to 1, once the largest principal stress of the elastic trial has reached `peak`. `longitudinal` is K +
  /// 4G/3: in uniaxial strain the stress falls linearly from s_t to zero at the strain e_f = 2 G_f/(s_t l_c), and since
  /// the energy released a unit of damage is peak^2/2(K + 4G/3), the area is G_f in uniaxial stress as well.
  template <class V>
  V damage(const V& peak, const V& particle_strength, double longitudinal, const V& size) const {
    const V end =
        max(V(2 * longitudinal * fracture_energy) / (particle_strength * size), V(1.0001) * particle_strength);
    const V reached = max(peak, particle_strength);
    const V kept = particle_strength / reached * (end - reached) / (end - particle_strength);
    return min(V(1), V(1) - max(kept, V(0)));
  }
};

/// A rock with a tensile law beside its own: Rankine damage d on the largest principal stress of the elastic trial,
/// stress (1 - d) trial + d `without_tension`. One scalar says how far a particle is cracked, but it acts only on the
/// directions in tension: cracks close in compression with the full stiffness, radial compression passes along an open
/// radial crack, and reopening meets the weakened rock. The rock's own strength sees this nominal stress.
///
/// `stress` is nominal, what the grid sees; `trial` is the deviator of the uncracked rock under the same elastic strain
/// (its pressure follows from J). They differ only where a cracked particle is in tension.
///
/// `Increment::size` is the crack band l_c and must be positive. It need not be frozen at the onset of cracking:
/// `cracking` never falls, and a particle is fully cracked before its size has changed by a per cent.
///
/// Rock is an aggregate law with `shear()`, `K1`, `elastic_trial` and `return_to_strength` as JohnsonHolmquist2 has
/// them.
template <class Rock>
struct WithTensileLaw : Rock {
  RankineSoftening tension{};

  template <class V>
  struct State {
    SymmetricTensor<V> stress{};  ///< nominal Cauchy stress, bulk viscosity included, Pa
    V damage{};                   ///< crushing D of the rock, 0 to 1
    V bulking{};                  ///< pressure of bulking, Pa
    SymmetricTensor<V> trial{};   ///< deviator without cracks, Pa
    V cracking{};                 ///< tensile damage, 0 to 1
    V opening{};                  ///< strain of the open cracks: what mu is larger by in the rock between them
    V strength{};                 ///< tensile strength of this particle, Pa
  };
  static constexpr std::array history{"damage",   "bulking",  "trial_xx", "trial_yy", "trial_zz", "trial_xy",
                                      "trial_yz", "trial_zx", "cracking", "opening",  "strength"};

  template <class V>
  State<V> initial() const {
    State<V> s;
    s.strength = V(tension.strength);
    return s;
  }

  /// Young's modulus in tension, Pa, from K1 and the shear modulus.
  double young_in_tension() const { return young_modulus(this->K1, this->shear()); }

  template <class V>
  void update(State<V>& s, const Increment<V>& step) const {
    const auto whole = this->elastic_trial(s.trial, s.bulking, step);
    const auto value = principal_values(whole);
    const double longitudinal = this->K1 + 4.0 / 3 * this->shear();
    s.cracking = max(s.cracking, tension.damage(value.first, s.strength, longitudinal, step.size));
    auto nominal = whole;
    if (any(s.cracking > V(0)))
      nominal = (V(1) - s.cracking) * whole + s.cracking * without_tension(whole, value, s, step.J);

    typename Rock::template State<V> rock{s.stress, s.damage, s.bulking};
    const V factor = this->return_to_strength(rock, nominal, step);
    s.stress = rock.stress;
    s.damage = rock.damage;
    s.bulking = rock.bulking;
    s.trial = factor * deviator(whole);
  }

  /// The larger moduli of the rock as compressed as the particle, and as compressed as it is between open cracks.
  template <class V>
  Moduli<V> tangent(const State<V>& s, const V& J) const {
    const typename Rock::template State<V> rock{s.stress, s.damage, s.bulking};
    const auto whole = Rock::tangent(rock, J), between = Rock::tangent(rock, J / (V(1) + J * s.opening));
    return {max(whole.longitudinal, between.longitudinal), whole.shear};
  }

  /// A state in static equilibrium with `stress`, uncracked. Needed because `trial` must agree with it.
  template <class V>
  State<V> state_of(const SymmetricTensor<V>& stress) const {
    State<V> s = initial<V>();
    s.stress = stress;
    s.trial = deviator(stress);
    return s;
  }

  /// The stress if no direction could carry tension: cracks open, normal to the principal directions, until their
  /// strain has taken the tension of the elastic `trial` away (the masonry-like solid of Del Piero 1989, here with the
  /// rock's own equation of state); sets `s.opening`. It derives from a potential, unlike the mere removal of tensile
  /// principal stresses, so that an open crack gives no energy away.
  template <class V>
  SymmetricTensor<V> without_tension(const SymmetricTensor<V>& trial, const PrincipalValues<V>& value, State<V>& s,
                                     const V& J) const {
    const V zero(0), one(1), third(1.0 / 3), G(this->shear()), mean = trace(trial) * third;
    if constexpr (std::is_floating_point_v<V>) {  // worth a branch where there are no lanes
      s.opening = zero;
      if (!(s.cracking > zero && value.first > zero)) return trial;
    }
    // One family of cracks: its opening brings the first principal stress, s1 - 4G/3 a - P, to zero.
    const auto one_family = crack_strain(value.first - mean, V(4.0 / 3) * G, J, s.bulking);
    const V push = V(2) * third * G * one_family.strain;
    // A second opens where that leaves tension: s1 + s2 - 2G/3 a - 2 P = 0 for their sum a.
    const auto two = value.second - mean + push > one_family.pressure;
    const auto both = crack_strain(V(-0.5) * (value.third - mean), third * G, J, s.bulking);
    const V column = value.third - mean + V(2) * third * G * both.strain - both.pressure;

    const V lone = select(two, value.third, value.first), other = select(two, value.first, value.third);
    const V weight = select(two, min(column, zero), V(-2) * G * one_family.strain);
    // The weight never exceeds either gap, so its square guards the quotient where principal values meet.
    const V gaps = max((lone - value.second) * (lone - other), max(weight * weight, V(1e-30)));
    const auto part = (weight / gaps) * shifted_product(trial, value.second, other);
    const V rest = select(two, zero, one);
    const auto cracked =
        part + rest * trial - SymmetricTensor<V>::spherical(rest * (mean + one_family.pressure - push));
    const V open = select(value.first > zero, one, zero);
    s.opening = select(s.cracking > zero, open * select(two, both.densified, one_family.densified), zero);
    return (one - open) * trial + open * cracked;
  }

 private:
  template <class V>
  struct Crack {
    V strain{};     ///< logarithmic, as the deviator's
    V pressure{};   ///< of the rock between the cracks, Pa
    V densified{};  ///< what mu is larger by there
  };

  /// Cracks of the strain a >= 0 at which the rock between them, of volume J e^-a, has the pressure s - g a. Newton on
  /// a monotone curve, from no elastic volume strain (J > 1) or no crack (J <= 1), so that e^-a needs two terms only.
  template <class V>
  Crack<V> crack_strain(const V& s, const V& g, const V& J, const V& bulking) const {
    const V start = max(log(J), V(0)), compaction = max(V(1) / J, V(1)), lowest = -min(start, V(0.9));
    V d(0), mu = compaction - V(1);
    for (int i = 0; i < 6; ++i) {
      const V excess = this->pressure(mu) + bulking + g * (start + d) - s;
      d = max(d - excess / (this->pressure_slope(mu) * compaction * (V(1) + d) + g), lowest);
      mu = compaction * (V(1) + d + V(0.5) * d * d) - V(1);
    }
    return {start + d, this->pressure(mu) + bulking, mu + V(1) - V(1) / J};
  }
};
template <class Rock>
WithTensileLaw(Rock, RankineSoftening) -> WithTensileLaw<Rock>;

}  // namespace mpm
