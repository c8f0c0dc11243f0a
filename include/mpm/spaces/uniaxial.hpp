// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/space.hpp>

namespace mpm {

/// Uniaxial strain along x: the one-dimensional bar or shock tube, per square metre of cross-section.
template <class Real = double>
struct Uniaxial : detail::SpaceBase<Real, 1, false> {
  static constexpr std::array stress_components{0, 1, 2};
  static constexpr std::array gradient_components{0};
};

static_assert(Space<Uniaxial<>>);

}  // namespace mpm
