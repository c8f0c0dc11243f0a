// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/bessel_k.hpp>
#include <mpm/analysis/durbin.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace mpm::analysis {

/// Pressure pulse P(t) = peak (e gamma t/n)^n exp(-gamma t) on a blast-hole wall (Blair's form; Eq 13 of Xiao et al.
/// 2024, Processes 12, 1048, whose exponent is misprinted). The largest pressure is `peak`, at t = n/gamma.
struct BlairLoad {
  double peak{};   ///< Pa
  double n{2};     ///< exponent of the rise, > 0
  double gamma{};  ///< rate of decay, 1/s

  double pressure(double t) const {
    return t > 0 ? peak * std::pow(std::numbers::e * gamma * t / n, n) * std::exp(-gamma * t) : 0;
  }
  /// Laplace transform of `pressure`, Pa s.
  std::complex<double> transform(std::complex<double> m) const {
    return peak * std::pow(std::numbers::e * gamma / n, n) * std::tgamma(n + 1) * std::pow(m + gamma, -(n + 1));
  }
};

/// State at one radius and time around a cavity: stresses (Pa, tension positive) and radial displacement (m, outward).
struct CavityState {
  double rr{}, tt{}, u{};
};

/// Extreme value (Pa) and its time (s).
struct Peak {
  double value{}, time{};
};

/// Extremes of a history: largest hoop stress, most compressive and most tensile radial stress.
struct CavityPeaks {
  Peak hoop, compression, tension;
};

/// Cylindrical cavity in an infinite linear elastic medium, plane strain, its wall loaded by the pressure `load` from
/// t = 0 on: exact solution in the Laplace domain by the potential A K0(m r/c_p), stresses and displacement (not the
/// potential) inverted by Durbin's method. Eqs 14 to 17 of Xiao et al. 2024 with the wall stress -P and the transform
/// put right.
struct BlastCavity {
  double young{};    ///< Pa
  double poisson{};  ///< < 0.5
  double density{};  ///< kg/m3
  double radius{};   ///< of the cavity, m
  BlairLoad load{};

  double shear_modulus() const { return young / (2 * (1 + poisson)); }
  /// lambda + 2 mu, Pa.
  double longitudinal_modulus() const { return young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)); }
  /// Longitudinal wave speed, m/s.
  double wave_speed() const { return std::sqrt(longitudinal_modulus() / density); }
  /// Time at which the front reaches radius r, s.
  double arrival(double r) const { return (r - radius) / wave_speed(); }

  /// State at radius r (m) and time t (s): zero until the front arrives. Errors are about 1e-10 of the peak.
  /// Throws std::invalid_argument inside the cavity or for parameters out of range.
  CavityState at(double r, double t) const {
    check(r);
    const double since = t - arrival(r);
    if (!(since > 0)) return {};
    const auto f =
        invert_durbin<3>([&](std::complex<double> m) { return transform(r, m); }, since, wave_speed() / radius);
    return {f[0], f[1], f[2]};
  }

  /// `at` for every time of `times`.
  std::vector<CavityState> history(double r, std::span<const double> times) const {
    std::vector<CavityState> states(times.size());
    std::transform(times.begin(), times.end(), states.begin(), [&](double t) { return at(r, t); });
    return states;
  }

  /// Extremes at radius r between the arrival of the front and `end` (s). Throws as `at`, and if `end` comes first.
  CavityPeaks peaks(double r, double end) const {
    constexpr std::size_t samples = 200;
    check(r);
    if (!(end > arrival(r)))
      throw std::invalid_argument("BlastCavity::peaks: the front reaches r = " + std::to_string(r) +
                                  " m only after the end time; choose end > " + std::to_string(arrival(r)) + " s");
    std::vector<double> times(samples + 1);
    for (std::size_t i = 0; i <= samples; ++i)
      times[i] = arrival(r) + (end - arrival(r)) * static_cast<double>(i) / samples;
    const std::vector<CavityState> states = history(r, times);
    return {maximum(
                r, times, states, [](const CavityState& s) { return s.tt; }, 1),
            maximum(
                r, times, states, [](const CavityState& s) { return s.rr; }, -1),
            maximum(
                r, times, states, [](const CavityState& s) { return s.rr; }, 1)};
  }

 private:
  void check(double r) const {
    if (!(young > 0 && poisson > -1 && poisson < 0.5 && density > 0 && radius > 0 && load.n > 0 && load.gamma > 0))
      throw std::invalid_argument(
          "BlastCavity: young, density, radius, load.n and load.gamma must be positive and -1 < poisson < 0.5");
    if (!(r >= radius))
      throw std::invalid_argument("BlastCavity: r = " + std::to_string(r) + " m lies inside the cavity of radius " +
                                  std::to_string(radius) + " m");
  }

  /// Transforms of rr, tt and u at radius r, times exp(m (r - a)/c_p): the time origin is the arrival there.
  std::array<std::complex<double>, 3> transform(double r, std::complex<double> m) const {
    const double longitudinal = longitudinal_modulus(), shear2 = 2 * shear_modulus();
    const std::complex<double> s = m / wave_speed();
    const ScaledBesselK wall = scaled_bessel_k(s * radius), here = r > radius ? scaled_bessel_k(s * r) : wall;
    const std::complex<double> amplitude =
        -load.transform(m) / (longitudinal * s * wall.k0 + shear2 / radius * wall.k1);  // A s
    return {amplitude * (longitudinal * s * here.k0 + shear2 / r * here.k1),
            amplitude * ((longitudinal - shear2) * s * here.k0 - shear2 / r * here.k1), -amplitude * here.k1};
  }

  /// Largest `sign` x component: the best sample, then golden section between its neighbours.
  template <class Component>
  Peak maximum(double r, const std::vector<double>& times, const std::vector<CavityState>& states,
               const Component& component, double sign) const {
    const auto less = [&](const CavityState& a, const CavityState& b) {
      return sign * component(a) < sign * component(b);
    };
    const auto best = static_cast<std::size_t>(std::max_element(states.begin(), states.end(), less) - states.begin());
    if (best == 0 || best + 1 == times.size()) return {component(states[best]), times[best]};
    double low = times[best - 1], high = times[best + 1];
    while (high - low > 1e-7 * high) {
      constexpr double golden = 1 / std::numbers::phi;
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      if (less(at(r, left), at(r, right)))
        low = left;
      else
        high = right;
    }
    const double time = 0.5 * (low + high);
    return {component(at(r, time)), time};
  }
};

}  // namespace mpm::analysis
