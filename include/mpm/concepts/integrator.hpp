// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>

namespace mpm {

/// When a step strains its particles.
enum class StressUpdate {
  first,         ///< USF: with the velocities before the forces act
  last,          ///< USL: with the advanced velocities
  modified_last  ///< MUSL: with the particles' new momenta, remapped to the nodes
};

/// INTEGRATOR: how nodes and particles go from one time to the next.
///   - `stress_update`: a StressUpdate;
///   - `keeps_node_velocity`: nodes carry their velocities from step to step, and particles carry none;
///   - `step_interval`: the stable step is computed again every so many steps;
///   - `advance(grid, dt)`: from v_I, f_I and m_I to v_I+ and the increment v_I+ - v_I; dt is the time between the
///     middles of the last step and this one;
///   - `particle_velocity(v_p, v, dv)`, unless nodes keep theirs: the new v_p from the old one and the interpolated
///     v_I+ and increment;
///   - optional `refine(grid, steps, residual)`, to undo what the transfers smooth: changes the advanced v_I+ and the
///     increment before they are gathered, and sets grid.strain_velocity, which then strains the particles;
///     `residual(field)` takes away from a nodal field what survives the way to the particles and back,
///     field -= M^-1 S^T m S field;
///   - optional `step_factor()`: the share of Irons' step that is stable with this integrator, where less than 1;
///   - optional `template <class Space> static constexpr int particle_columns`, where particles carry more than x and
///   v:
///     so many scalars a particle, which Transfer keeps, zero at the start, and reorders with the body. With it
///     `scatter_momentum(body, order, columns, grid, momentum)`, which takes the place of the pass of that name, and
///     `gather_columns(body, grid, columns)`, after the particles have their new velocities; both static.
template <class I>
concept Integrator = requires {
  { I::stress_update } -> std::convertible_to<StressUpdate>;
  { I::keeps_node_velocity } -> std::convertible_to<bool>;
  { I::step_interval } -> std::convertible_to<int>;
}
&&(I::keeps_node_velocity || requires(const I integrator, double v) {
  { integrator.particle_velocity(v, v, v) } -> std::convertible_to<double>;
});

/// Scalars a particle that the integrator keeps for itself.
template <class I, class S>
inline constexpr int particle_columns = 0;
template <class I, class S>
requires requires {
  I::template particle_columns<S>;
}
inline constexpr int particle_columns<I, S> = I::template particle_columns<S>;

}  // namespace mpm
