// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/space.hpp>

namespace mpm {

/// Plane strain: x, y; no strain along z, but a stress there. Forces, masses and energies are per metre of depth.
template <class Real = double>
struct PlaneStrain : detail::SpaceBase<Real, 2, false> {
  static constexpr std::array stress_components{0, 1, 2, 3};
  static constexpr std::array gradient_components{0, 1, 3, 4};
};

static_assert(Space<PlaneStrain<>>);

}  // namespace mpm
