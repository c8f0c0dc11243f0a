// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/tensor.hpp>
#include <array>
#include <concepts>

namespace mpm {

/// SPACE: binds the dimension and the scalar once, and lifts what the grid sees to the 3x3 tensors of a law.
///   - `Scalar`, `dimension`;
///   - `stress_components`: which of xx yy zz xy yz zx (0..5) can be non-zero and are stored;
///   - `gradient_components`: the same of the row-major deformation gradient (0..8);
///   - `hoop`: the first axis is a radius; v_r / r enters the velocity gradient (its zz), and sigma_zz / r the force.
///     Volumes and masses are then those of one radian.
template <class S>
concept Space = std::floating_point<typename S::Scalar> && requires {
  { S::dimension } -> std::convertible_to<int>;
  { S::stress_components.size() } -> std::convertible_to<std::size_t>;
  { S::gradient_components.size() } -> std::convertible_to<std::size_t>;
  { S::hoop } -> std::convertible_to<bool>;
};

namespace detail {
template <class Real, int Dimension, bool Hoop>
struct SpaceBase {
  using Scalar = Real;
  static constexpr int dimension = Dimension;
  static constexpr bool hoop = Hoop;
};
}  // namespace detail
}  // namespace mpm
