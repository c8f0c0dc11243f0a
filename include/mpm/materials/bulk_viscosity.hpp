// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/tensor.hpp>

namespace mpm {

/// Artificial bulk viscosity (von Neumann & Richtmyer 1950, with Landshoff's linear term): smears a shock over a few
/// cells. It acts in compression only, and it is part of the stress, so it enters force and energy alike. Both
/// coefficients zero switch it off. A law that has one shows it as its member `viscosity`; the step control of the
/// solver shrinks the step by `step_factor`.
struct BulkViscosity {
  double quadratic = 1.5;  ///< c0, dimensionless
  double linear = .06;     ///< c1, dimensionless

  /// q = rho h (c1 c |tr D| + c0 h (tr D)^2) for tr D < 0, else 0; Pa. `density` and `sound_speed` are the current
  /// ones, `rate` is tr D in 1/s and h the cell in m.
  template <class V>
  V pressure(const V& density, const V& sound_speed, const V& rate, const V& h) const {
    const V closing = max(-rate, V(0));
    return density * h * closing * (V(linear) * sound_speed + V(quadratic) * h * closing);
  }

  /// What a stable step shrinks by: sqrt(1 + x^2) - x with x = c1 + c0 h |tr D|/c in compression, 1 in expansion and
  /// where nothing is stiff (c = 0).
  template <class V>
  V step_factor(const V& sound_speed, const V& rate, const V& h) const {
    const V ratio = h * max(-rate, V(0)) / max(sound_speed, V(1e-30));
    const V x = select(rate < V(0), V(linear) + V(quadratic) * ratio, V(0));
    return select(sound_speed > V(0), V(1) / (sqrt(V(1) + x * x) + x), V(1));
  }
};

}  // namespace mpm
