// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/boundaries/quiet.hpp>
#include <mpm/boundaries/rollers.hpp>
#include <mpm/boundaries/traction.hpp>
#include <mpm/boundaries/viscous_spring.hpp>
#include <variant>

namespace mpm {

namespace detail {
template <class Face, class S>
inline constexpr bool all_are_boundaries = false;
template <class... F, class S>
inline constexpr bool all_are_boundaries<std::variant<F...>, S> = (BoundaryCondition<F, S> && ...);
}  // namespace detail

/// The boundary conditions of the grid's faces, chosen at run time, visited once a face and step.
template <Space S>
class Box {
 public:
  using Face = std::variant<Free<S>, Rollers<S>, Fixed<S>, Traction<S>, Quiet<S>, ViscousSpring<S>>;
  static_assert(detail::all_are_boundaries<Face, S>, "mpm::Box: a face's alternative is no BoundaryCondition");

  /// Face of `axis` on `side` (0 lower, 1 upper).
  Face& face(int axis, int side) { return faces_[2 * axis + side]; }

  void load(Grid<S>& grid) {
    visit([&](auto& f, int axis, int side) { f.load(grid, axis, side); });
  }
  void constrain(std::vector<Vector<S>>& field, const Grid<S>& grid) {
    visit([&](auto& f, int axis, int side) { f.constrain(field, grid, axis, side); });
  }
  void absorb(Grid<S>& grid, typename S::Scalar dt) {
    visit([&](auto& f, int axis, int side) { f.absorb(grid, axis, side, dt); });
  }
  /// Stores the reactions to the nodal forces now in the grid in every quiet face; a shared edge counts once.
  void hold(const Grid<S>& grid) {
    std::vector<char> held(grid.size(), 0);
    visit([&](auto& f, int axis, int side) {
      if constexpr (requires { f.reaction; }) {
        f.reaction.clear();
        grid.for_each_on_face(axis, side, [&](int node, const auto&) {
          f.reaction.push_back(held[node] ? Vector<S>::Zero().eval() : (-grid.increment[node]).eval());
          held[node] = 1;
        });
      }
    });
  }
  /// Work done on the bodies by all faces, J.
  double work() {
    double sum = 0;
    visit([&](auto& f, int, int) { sum += f.work; });
    return sum;
  }

 private:
  template <class F>
  void visit(const F& f) {
    for (int k = 0; k < 2 * S::dimension; ++k) std::visit([&](auto& face) { f(face, k / 2, k % 2); }, faces_[k]);
  }

  std::array<Face, 2 * S::dimension> faces_;
};

}  // namespace mpm
