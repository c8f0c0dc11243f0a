// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/grid.hpp>

namespace mpm {

/// BOUNDARY CONDITION of one face of the grid; `axis` is its normal, `side` 0 the lower and 1 the upper face.
///   - `load(grid, axis, side)`: adds its forces to the nodal forces;
///   - `constrain(field, grid, axis, side)`: takes the components it prescribes out of a nodal field: velocities, and
///     the forces that would change them;
///   - `absorb(grid, axis, side, dt)`: changes the advanced velocities implicitly, the increment with them;
///   - `work`: what it has done on the bodies, J.
template <class B, class S>
concept BoundaryCondition = requires(B b, Grid<S> grid, std::vector<Vector<S>> field, typename S::Scalar dt) {
  b.load(grid, 0, 0);
  b.constrain(field, grid, 0, 0);
  b.absorb(grid, 0, 0, dt);
  { b.work } -> std::convertible_to<double>;
};

/// Area of a face of axis `axis` that belongs to the node at index i: cells around it, half ones at an edge; times the
/// radius in a space with a hoop direction.
template <Space S>
typename S::Scalar tributary_area(const Grid<S>& grid, int axis, const std::array<int, S::dimension>& i) {
  typename S::Scalar area = 1;
  for (int d = 0; d < S::dimension; ++d) {
    if (d == axis) continue;
    area *= grid.cell() * (i[d] == 0 || i[d] == grid.cells(d) ? typename S::Scalar(0.5) : typename S::Scalar(1));
  }
  if constexpr (S::hoop) area *= grid.origin()[0] + grid.cell() * typename S::Scalar(i[0]);
  return area;
}

}  // namespace mpm
