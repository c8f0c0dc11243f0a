// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/grid.hpp>

namespace mpm {

/// Symplectic Euler on the nodes: v_I+ = v_I + dt f_I / m_I. grid.increment holds f_I before and v_I+ - v_I after.
template <class S>
void advance_nodes(Grid<S>& grid, typename S::Scalar dt) {
  grid.for_each_active([&](int node) {
    if (!(grid.mass[node] > 0)) return;
    grid.increment[node] *= dt / grid.mass[node];
    grid.velocity[node] += grid.increment[node];
  });
}

}  // namespace mpm
