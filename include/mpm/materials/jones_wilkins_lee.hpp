// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/material.hpp>
#include <mpm/materials/bulk_viscosity.hpp>
#include <array>

namespace mpm {

/// How an explosive turns into gas.
enum class Burn {
  constant_volume,  ///< a particle all at once: right where the front runs out of the plane computed
  programmed        ///< from the lighting time of each particle, at the detonation velocity
};

/// The Chapman-Jouguet state behind a plane steady detonation.
struct ChapmanJouguet {
  double velocity = 0;  ///< D, m/s
  double pressure = 0;  ///< p_CJ, Pa
  double volume = 0;    ///< V_CJ, relative
};

/// Detonation products after Jones, Wilkins & Lee (Xiao et al. 2024, Eq 19):
/// p = A (1 - w/(R1 V)) e^(-R1 V) + B (1 - w/(R2 V)) e^(-R2 V) + w E/V, with V the *current* relative volume and E the
/// energy per initial volume. The pressure the grid sees is F p + q: burned fraction times p, and bulk viscosity. The
/// energy equation takes the trapezoid of that very pressure, implicitly, so that energy lost equals work done.
struct JonesWilkinsLee {
  double density = 1260;              ///< rho0, kg/m3
  double A = 0, B = 0;                ///< Pa
  double R1 = 1, R2 = 1, omega = .3;  ///< dimensionless
  double initial_energy = 0;          ///< E0, J/m3
  Burn burn = Burn::constant_volume;
  double detonation_velocity = 0;     ///< D of the programmed burn, m/s; see `with_own_detonation`
  double chapman_jouguet_volume = 0;  ///< V_CJ of the programmed burn
  BulkViscosity viscosity{};

  template <class V>
  struct State {
    V pressure{};       ///< F p + q, compression positive, Pa
    V energy{};         ///< E per initial volume, J/m3
    V burned{};         ///< burned fraction F
    V lighting_time{};  ///< s; min over the detonators of t_d + |x - x_d|/D, set by the program: `unlit`
  };
  static constexpr std::array history{"energy", "burned", "lighting_time"};

  template <class V>
  State<V> initial() const {
    const V burned(burn == Burn::constant_volume ? 1 : 0), energy(initial_energy);
    return {burned * pressure(V(1), energy), energy, burned, V(0)};
  }

  /// State of explosive that nothing has lit before `time`, s.
  State<double> unlit(double time) const { return {0, initial_energy, 0, time}; }

  /// Pressure of the products, Pa.
  template <class V>
  V pressure(const V& volume, const V& energy) const {
    return cold(isentrope(volume)) + V(omega) * energy / volume;
  }

  /// Isentropic bulk modulus -V dp/dV (dE = -p dV) of the products, Pa.
  template <class V>
  V bulk_modulus(const V& volume, const V& energy) const {
    return bulk_modulus(isentrope(volume), energy / volume);
  }

  /// The sound speed in the viscosity is that of the new volume and the old energy.
  template <class V>
  void update(State<V>& s, const Increment<V>& step) const {
    s.burned = burned_fraction(s, step);
    const V inverse = V(1) / step.J, density_now = V(density) * inverse, F = s.burned;
    const auto parts = isentrope(step.J);
    const V c = sqrt(max(bulk_modulus(parts, s.energy * inverse), V(0)) * step.J * V(1 / density));
    const V q = viscosity.pressure(density_now, c, trace(step.L), step.cell);
    const V dV = step.J - step.J_old, a = cold(parts), b = V(omega) * inverse;
    s.energy = (s.energy - V(0.5) * dV * (s.pressure + F * a + q)) / (V(1) + V(0.5) * dV * F * b);
    s.pressure = F * (a + b * s.energy) + q;
  }

  /// Bulk modulus of the products; while a programmed burn is under way also the rise of F with compression.
  template <class V>
  Moduli<V> tangent(const State<V>& s, const V& J) const {
    V bulk = bulk_modulus(J, s.energy);
    if (burn == Burn::programmed) {
      const V rise = J * pressure(J, s.energy) / V(1 - chapman_jouguet_volume);
      bulk += select(s.burned < V(1), max(rise, V(0)), V(0));
    }
    return {max(bulk, V(0)), V(0)};
  }

  /// Chapman-Jouguet state of the constants: where the Rayleigh line p = rho0 D^2 (1 - V) touches the Hugoniot
  /// E = E0 + p (1 - V)/2, there also the isentrope has its slope.
  ChapmanJouguet chapman_jouguet() const {
    const auto hugoniot = [this](double v) {
      return (cold(isentrope(v)) + omega / v * initial_energy) / (1 - omega / v * (1 - v) / 2);
    };
    double low = .4, high = .999;
    for (int i = 0; i < 100; ++i) {
      const double v = (low + high) / 2, p = hugoniot(v), energy = initial_energy + p * (1 - v) / 2;
      (bulk_modulus(v, energy) * (1 - v) > p * v ? low : high) = v;
    }
    const double p = hugoniot(low);
    return {std::sqrt(p / (density * (1 - low))), p, low};
  }

  /// This law with a programmed burn at the velocity its own constants demand; any other D is at odds with them.
  JonesWilkinsLee with_own_detonation() const {
    const auto state = chapman_jouguet();
    JonesWilkinsLee law = *this;
    law.burn = Burn::programmed;
    law.detonation_velocity = state.velocity;
    law.chapman_jouguet_volume = state.volume;
    return law;
  }

 private:
  /// What the exponentials are at a volume V: A e^(-R1 V) and B e^(-R2 V), and w over the exponents.
  template <class V>
  struct Isentrope {
    V x, y, a, b, w_x, w_y;
  };
  template <class V>
  Isentrope<V> isentrope(const V& volume) const {
    const V x = V(R1) * volume, y = V(R2) * volume, inverse = V(omega) / volume;
    return {x, y, V(A) * exp(-x), V(B) * exp(-y), V(1 / R1) * inverse, V(1 / R2) * inverse};
  }
  template <class V>
  V cold(const Isentrope<V>& i) const {
    return i.a * (V(1) - i.w_x) + i.b * (V(1) - i.w_y);
  }
  /// With the energy per current volume.
  template <class V>
  V bulk_modulus(const Isentrope<V>& i, const V& energy) const {
    const V w(omega), slope = i.a * (i.x - w - i.w_x) + i.b * (i.y - w - i.w_y);
    return slope + w * (cold(i) + V(omega + 1) * energy);
  }

  /// F = min(1, max(F1, F2)), never falling: F1 smears the front over 1.5 cells behind the lighting time, F2 lets
  /// compression burn (Wilkins 1964).
  template <class V>
  V burned_fraction(const State<V>& s, const Increment<V>& step) const {
    if (burn == Burn::constant_volume) return select(step.time < s.lighting_time, s.burned, V(1));
    const V by_time = max(step.time - s.lighting_time, V(0)) * V(detonation_velocity) / (V(1.5) * step.cell);
    const V by_volume = (V(1) - step.J) / V(1 - chapman_jouguet_volume);
    return min(V(1), max(s.burned, max(by_time, by_volume)));
  }
};
static_assert(Fluid<JonesWilkinsLee> && !needs_deformation_gradient<JonesWilkinsLee>);

}  // namespace mpm
