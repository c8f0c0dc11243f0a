// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/space.hpp>

namespace mpm {

/// One-dimensional cylinder in plane strain: x is the radius, zz the hoop direction, yy the axis; per radian and metre.
template <class Real = double>
struct Radial : detail::SpaceBase<Real, 1, true> {
  static constexpr std::array stress_components{0, 1, 2};
  static constexpr std::array gradient_components{0, 8};
};

static_assert(Space<Radial<>>);

}  // namespace mpm
