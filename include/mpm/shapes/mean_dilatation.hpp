// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/shape_function.hpp>

namespace mpm {

/// A shape with a remedy for volumetric locking: every particle of a cell takes up the mean rate of volume of them all,
/// so that they cannot demand more of its nodes than these can give. Mean dilatation of Nagtegaal, Parks & Rice (1974),
/// in rates; its finite-strain form is known as F-bar (de Souza Neto et al. 1996). Takes the plain passes.
template <ShapeFunction Shape>
struct MeanDilatation : Shape {
  static constexpr bool mean_dilatation = true;
};

}  // namespace mpm
