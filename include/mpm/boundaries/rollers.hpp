// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/boundary.hpp>

namespace mpm {

/// Nothing acts on the face.
template <Space S>
struct Free {
  double work = 0;
  void load(Grid<S>&, int, int) const {}
  void constrain(std::vector<Vector<S>>&, const Grid<S>&, int, int) const {}
  void absorb(Grid<S>&, int, int, typename S::Scalar) const {}
};

/// No motion across the face: a symmetry plane or a smooth wall.
template <Space S>
struct Rollers : Free<S> {
  void constrain(std::vector<Vector<S>>& field, const Grid<S>& grid, int axis, int side) const {
    grid.for_each_on_face(axis, side, [&](int node, const auto&) { field[node][axis] = 0; });
  }
};

/// No motion at all at the face: a rough wall.
template <Space S>
struct Fixed : Free<S> {
  void constrain(std::vector<Vector<S>>& field, const Grid<S>& grid, int axis, int side) const {
    grid.for_each_on_face(axis, side, [&](int node, const auto&) { field[node].setZero(); });
  }
};

}  // namespace mpm
