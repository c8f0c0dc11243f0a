// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/gas_state.hpp>
#include <mpm/materials/jones_wilkins_lee.hpp>
#include <array>
#include <cmath>
#include <stdexcept>

namespace mpm::analysis {

/// Plane detonation of a JWL explosive lit at a rigid wall at x = 0: the Taylor wave (Taylor 1950, Proc. R. Soc. A 200,
/// 235). The front runs at the Chapman-Jouguet velocity D that the constants themselves demand, whatever the burn of
/// the law; behind it a rarefaction u + c = x/t along the isentrope through the CJ state brings the products to rest.
class TaylorWave {
 public:
  /// Throws std::invalid_argument for constants without a CJ state from which the products come to rest.
  explicit TaylorWave(const JonesWilkinsLee& law) : law_(law), front_(law.chapman_jouguet()) {
    constant_ = (front_.pressure - pressure(front_.volume, 0)) * std::pow(front_.volume, 1 + law_.omega);
    double high = front_.volume;
    while (velocity(high) > 0 && high < 100) high *= 1.1;
    const double sonic = velocity(front_.volume) + sound(front_.volume);  // = D at a true CJ state
    if (!(std::abs(sonic - front_.velocity) < 1e-6 * front_.velocity && velocity(high) <= 0))
      throw std::invalid_argument(
          "TaylorWave: these JWL constants have no CJ state from which the products come to rest; check A, B, R1, R2, "
          "omega, initial_energy and density");
    rest_volume_ = bisect(high, [this](double v) { return velocity(v); });
  }

  /// Velocity D, pressure and relative volume right behind the front.
  const ChapmanJouguet& front() const { return front_; }
  /// x/(D t) below which the products rest.
  double rest() const { return sound(rest_volume_) / front_.velocity; }
  /// C of the isentrope p = A e^(-R1 V) + B e^(-R2 V) + C V^(-1-omega) through the CJ state, Pa.
  double isentrope_constant() const { return constant_; }

  /// State at x/(D t); above 1 the explosive ahead of the front. Throws std::invalid_argument behind the wall.
  GasState at(double position) const {
    if (!(position >= 0)) throw std::invalid_argument("TaylorWave: x/(D t) must not be negative, the wall is at 0");
    if (position > 1) return {law_.density, 0, 0};
    if (position <= rest()) return {law_.density / rest_volume_, 0, pressure(rest_volume_, constant_)};
    const double speed = position * front_.velocity;
    const double v = bisect(rest_volume_, [&](double w) { return velocity(w) + sound(w) - speed; });
    return {law_.density / v, velocity(v), pressure(v, constant_)};
  }

 private:
  double pressure(double v, double constant) const {
    return law_.A * std::exp(-law_.R1 * v) + law_.B * std::exp(-law_.R2 * v) + constant * std::pow(v, -1 - law_.omega);
  }
  /// c = V sqrt(-dp/dV / rho0), m/s.
  double sound(double v) const {
    const double slope = law_.A * law_.R1 * std::exp(-law_.R1 * v) + law_.B * law_.R2 * std::exp(-law_.R2 * v) +
                         (1 + law_.omega) * constant_ * std::pow(v, -2 - law_.omega);
    return v * std::sqrt(slope / law_.density);
  }
  /// u = u_CJ - integral of c d(ln V) from the front, m/s; Gauss quadrature, five points on each of four panels.
  double velocity(double v) const {
    constexpr int panels = 4;
    constexpr std::array<double, 5> x{-.9061798459386640, -.5384693101056831, 0, .5384693101056831, .9061798459386640},
        w{.2369268850561891, .4786286704993665, .5688888888888889, .4786286704993665, .2369268850561891};
    const double half = 0.5 * std::log(v / front_.volume) / panels;
    double u = front_.velocity * (1 - front_.volume);
    for (int panel = 0; panel < panels; ++panel)
      for (std::size_t i = 0; i < x.size(); ++i)
        u -= half * w[i] * sound(front_.volume * std::exp(half * (2 * panel + 1 + x[i])));
    return u;
  }
  /// Root between the CJ volume and `high` of a function that falls from positive to negative there.
  template <class Function>
  double bisect(double high, const Function& falling) const {
    double low = front_.volume;
    for (int i = 0; i < 60; ++i) {
      const double v = 0.5 * (low + high);
      (falling(v) > 0 ? low : high) = v;
    }
    return 0.5 * (low + high);
  }

  JonesWilkinsLee law_;
  ChapmanJouguet front_;
  double constant_{}, rest_volume_{};
};

}  // namespace mpm::analysis
