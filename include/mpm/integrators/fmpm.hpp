// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/integrator.hpp>
#include <mpm/error.hpp>
#include <mpm/integrators/full_mass_series.hpp>
#include <mpm/passes/advance_nodes.hpp>
#include <cmath>

namespace mpm {

/// FMPM(k), the full mass matrix approached by k terms of a series (Nairn & Hammerquist 2021): the particles take the
/// velocity v(k) = sum_{r<k} (1 - M^-1 S^T m S)^r v+ of the nodes, M the lumped mass, and keep none of their own.
///
/// Filters what the grid cannot see like PIC, which is k = 1, and smooths what it can see the less the larger k. The
/// stress is updated last.
struct Fmpm {
  int order = 2;              ///< k, 1 or more
  int interval = 1;           ///< steps from one use to the next; FLIP in between, which smooths less in many steps
  double strain_share = 0.5;  ///< share of v(k) in the velocity that strains, the rest is v+: lumped masses make waves
                              ///< slow, the full ones fast, and at one half their errors of order h^2 cancel
  bool refined = true;        ///< whether the last step used it

  static constexpr StressUpdate stress_update = StressUpdate::last;
  static constexpr bool keeps_node_velocity = false;
  static constexpr int step_interval = 1;

  template <class S>
  void advance(Grid<S>& grid, typename S::Scalar dt) const {
    advance_nodes(grid, dt);
  }
  /// v(k) into grid.velocity. Throws Error on parameters out of range.
  template <class S, class Residual>
  void refine(Grid<S>& grid, std::int64_t steps, const Residual& residual) {
    if (order < 1 || interval < 1 || !(strain_share >= 0 && strain_share <= 1))
      throw Error("mpm::Fmpm: order and interval must be 1 or more, and strain_share within 0 and 1");
    refined = steps % interval == 0;
    if (refined) {
      detail::refine_velocity(grid, order, typename S::Scalar(strain_share), residual);
    } else {
      grid.for_each_active([&](int node) { grid.strain_velocity[node] = grid.velocity[node]; });
    }
  }
  template <class Scalar>
  Scalar particle_velocity(Scalar old, Scalar v, Scalar increment) const {
    return refined ? v : old + increment;
  }
  /// Irons' bound keeps dt^2 l < 4 for every eigenvalue l of M^-1 K. A mode with the eigenvalue p of M^-1 S^T m S is
  /// stable while dt^2 l q < 2 (1 + p q_k): q_k = (1 - (1-p)^k)/p is its factor in v(k), q = 1 + strain_share (q_k - 1)
  /// that in the strain. The worst p is 0, motion that no particle sees; splines would stand twice as much.
  double step_factor() const { return std::sqrt(0.5 / (1 + strain_share * (order - 1))); }
};

static_assert(Integrator<Fmpm>);

}  // namespace mpm
