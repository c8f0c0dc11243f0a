// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/integrator.hpp>
#include <mpm/passes/advance_nodes.hpp>
#include <cmath>

namespace mpm {

/// Explicit dynamics, symplectic Euler on the nodes, with a blend of FLIP and PIC to the particles.
template <StressUpdate When>
struct Explicit {
  double flip = 1;  ///< 1: the increment (FLIP, Brackbill & Ruppel 1986), 0: the nodal velocity itself (PIC)

  static constexpr StressUpdate stress_update = When;
  static constexpr bool keeps_node_velocity = false;
  static constexpr int step_interval = 1;

  template <class S>
  void advance(Grid<S>& grid, typename S::Scalar dt) const {
    advance_nodes(grid, dt);
  }
  /// Share of the stable step. USL strains with velocities that the remap has not smoothed yet: a mode that the
  /// transfers pass on by a share p (an eigenvalue of M^-1 S^T m S) is stable while dt^2 w^2 < 4/(2 - p), at worst half
  /// of Irons'.
  double step_factor() const { return When == StressUpdate::last ? std::sqrt(0.5) : 1; }

  template <class Scalar>
  Scalar particle_velocity(Scalar old, Scalar v, Scalar increment) const {
    const Scalar f(flip);
    return f * (old + increment) + (Scalar(1) - f) * v;
  }
};

using Usf = Explicit<StressUpdate::first>;
using Usl = Explicit<StressUpdate::last>;
using Musl = Explicit<StressUpdate::modified_last>;

static_assert(Integrator<Usf> && Integrator<Usl> && Integrator<Musl>);

}  // namespace mpm
