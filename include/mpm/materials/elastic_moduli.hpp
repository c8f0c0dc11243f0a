// SPDX-License-Identifier: MIT
#pragma once

namespace mpm {

/// Shear modulus G = mu of Young's modulus and Poisson's ratio, Pa.
constexpr double shear_modulus(double young, double poisson) {
  return young / (2 * (1 + poisson));
}
/// Lame's first modulus lambda of Young's modulus and Poisson's ratio, Pa.
constexpr double lame_modulus(double young, double poisson) {
  return young * poisson / ((1 + poisson) * (1 - 2 * poisson));
}
/// Young's modulus of bulk and shear modulus, Pa.
constexpr double young_modulus(double bulk, double shear) {
  return 9 * bulk * shear / (3 * bulk + shear);
}

}  // namespace mpm
