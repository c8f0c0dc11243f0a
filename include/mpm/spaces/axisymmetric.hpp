// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/space.hpp>

namespace mpm {

/// Axial symmetry: x is the radius, y the axis, zz the hoop direction; per radian.
template <class Real = double>
struct Axisymmetric : detail::SpaceBase<Real, 2, true> {
  static constexpr std::array stress_components{0, 1, 2, 3};
  static constexpr std::array gradient_components{0, 1, 3, 4, 8};
};

static_assert(Space<Axisymmetric<>>);

}  // namespace mpm
