// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/boundaries/rollers.hpp>
#include <cmath>

namespace mpm {

/// A given stress outside the face: f_I = integral of N_I sigma n dA, times `scale`, at the nodes a body has reached.
template <Space S>
struct Traction : Free<S> {
  using Scalar = typename S::Scalar;

  std::vector<Vector<S>> force;  ///< at unit scale, in the order of the face's nodes, N
  Scalar scale = 1;              ///< may change between steps

  /// `stress(x)` returns the traction sigma n at x on the face, Pa; integrated with two Gauss points a cell and axis.
  template <class F>
  static Traction on(const Grid<S>& grid, int axis, int side, const F& stress) {
    Traction result;
    grid.for_each_on_face(axis, side, [&](int node, const auto& index) {
      result.force.push_back(integrate(grid, grid.position(node), index, axis, 0, Scalar(1), stress));
    });
    return result;
  }
  void load(Grid<S>& grid, int axis, int side) const {
    std::size_t k = 0;
    grid.for_each_on_face(axis, side, [&](int node, const auto&) {
      const Vector<S> f = scale * force[k++];
      if (grid.mass[node] > 0) grid.increment[node] += f;
    });
  }
  void absorb(const Grid<S>& grid, int axis, int side, Scalar dt) {
    std::size_t k = 0;
    grid.for_each_on_face(axis, side, [&](int node, const auto&) {
      const Vector<S> f = scale * force[k++];
      if (grid.mass[node] > 0)
        this->work += double(dt * f.dot(grid.velocity[node] - Scalar(0.5) * grid.increment[node]));
    });
  }

 private:
  /// Integrates over the cells around a node, one tangential axis after the other.
  template <class F>
  static Vector<S> integrate(const Grid<S>& grid, Vector<S> x, const std::array<int, S::dimension>& index, int axis,
                             int d, Scalar weight, const F& stress) {
    if (d == axis) ++d;
    if (d >= S::dimension) return (S::hoop ? weight * x[0] : weight) * stress(x);
    Vector<S> sum = Vector<S>::Zero();
    for (const int side : {-1, 1}) {
      if (index[d] + side < 0 || index[d] + side > grid.cells(d)) continue;
      for (const Scalar s : {Scalar(0.5 - 0.5 / std::sqrt(3.0)), Scalar(0.5 + 0.5 / std::sqrt(3.0))}) {
        Vector<S> at = x;
        at[d] += Scalar(side) * s * grid.cell();
        sum += integrate(grid, at, index, axis, d + 1, weight * (1 - s) * grid.cell() / 2, stress);
      }
    }
    return sum;
  }
};

}  // namespace mpm
