// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/integrator.hpp>
#include <mpm/error.hpp>
#include <mpm/integrators/full_mass_series.hpp>
#include <mpm/passes/advance_nodes.hpp>
#include <cmath>
#include <cstdint>

namespace mpm {

/// FLIP with the increment unsmoothed: v_p += S sum_{r<k} (1 - M^-1 S^T m S)^r (v+ - v), M the lumped mass. The series
/// is that of FMPM(k) (Nairn & Hammerquist 2021), on the increment: for large k the particles are accelerated by the
/// full mass matrix S^T m S (Burgess, Sulsky & Brackbill 1992), and k = 1 is FLIP.
///
/// What particles know and the grid does not see is kept as in FLIP, so it neither dissipates nor filters. The stress
/// is updated last.
struct FullMassFlip {
  int order = 2;  ///< k, 1 or more
  /// Share of v(k), as in Fmpm, in the velocity that strains; the rest is v+. Particles move with v(k) unless it is 0.
  /// Cancels dispersion, as an acceleration alone cannot, at one half with GIMP and CPDI and at 1 with splines.
  double strain_share = 0;

  static constexpr StressUpdate stress_update = StressUpdate::last;
  static constexpr bool keeps_node_velocity = false;
  static constexpr int step_interval = 1;

  template <class S>
  void advance(Grid<S>& grid, typename S::Scalar dt) const {
    advance_nodes(grid, dt);
  }
  /// The series into grid.increment, and with a share of v(k) that into grid.velocity. Throws Error on parameters out
  /// of range.
  template <class S, class Residual>
  void refine(Grid<S>& grid, std::int64_t, const Residual& residual) const {
    if (order < 1 || !(strain_share >= 0 && strain_share <= 1))
      throw Error("mpm::FullMassFlip: order must be 1 or more, and strain_share within 0 and 1");
    detail::sum_full_mass_series(grid, grid.increment, order, residual);
    grid.for_each_active([&](int node) { grid.increment[node] = grid.strain_velocity[node]; });
    if (strain_share > 0) {
      detail::refine_velocity(grid, order, typename S::Scalar(strain_share), residual);
    } else {
      grid.for_each_active([&](int node) { grid.strain_velocity[node] = grid.velocity[node]; });
    }
  }
  template <class Scalar>
  Scalar particle_velocity(Scalar old, Scalar, Scalar increment) const {
    return old + increment;
  }
  /// Irons' bound keeps dt^2 l < 4 for every eigenvalue l of M^-1 K. A mode with the eigenvalue p of M^-1 S^T m S takes
  /// the share P = 1 - (1-p)^k of its increment on to the next step and is stable while dt^2 l q < 4/(2 - P), with q =
  /// 1 + strain_share (P/p - 1) the factor of its strain. The worst p is 0, motion that no particle sees.
  double step_factor() const { return std::sqrt(0.5 / (1 + strain_share * (order - 1))); }
};

static_assert(Integrator<FullMassFlip>);

}  // namespace mpm
