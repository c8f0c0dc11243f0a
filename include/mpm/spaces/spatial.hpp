// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/space.hpp>

namespace mpm {

/// Three dimensions.
template <class Real = double>
struct Spatial : detail::SpaceBase<Real, 3, false> {
  static constexpr std::array stress_components{0, 1, 2, 3, 4, 5};
  static constexpr std::array gradient_components{0, 1, 2, 3, 4, 5, 6, 7, 8};
};

static_assert(Space<Spatial<>>);

}  // namespace mpm
