// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/grid.hpp>
#include <utility>

// The full mass matrix S^T m S approached by k terms of a series in P = M^-1 S^T m S, M the lumped mass (Nairn &
// Hammerquist 2021). `residual(field)` is field -= P field, as an integrator's `refine` gets it.
namespace mpm::detail {

/// grid.strain_velocity = sum_{r<k} (1 - P)^r field, by Horner's rule.
template <class S, class Residual>
void sum_full_mass_series(Grid<S>& grid, const std::vector<Vector<S>>& field, int order, const Residual& residual) {
  grid.for_each_active([&](int node) { grid.strain_velocity[node] = field[node]; });
  for (int r = 1; r < order; ++r) {
    residual(grid.strain_velocity);
    grid.for_each_active([&](int node) { grid.strain_velocity[node] += field[node]; });
  }
}

/// grid.velocity = v(k), the series of v+, and grid.strain_velocity = v+ + share (v(k) - v+).
template <class S, class Residual>
void refine_velocity(Grid<S>& grid, int order, typename S::Scalar share, const Residual& residual) {
  sum_full_mass_series(grid, grid.velocity, order, residual);
  grid.for_each_active([&](int node) {
    std::swap(grid.velocity[node], grid.strain_velocity[node]);
    grid.strain_velocity[node] += share * (grid.velocity[node] - grid.strain_velocity[node]);
  });
}

}  // namespace mpm::detail
