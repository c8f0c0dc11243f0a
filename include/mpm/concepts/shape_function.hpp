// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>
#include <cstdint>
#include <span>

namespace mpm {

/// How a particle's domain follows the motion.
enum class DomainMotion {
  rigid,                 ///< keeps its size (linear, uGIMP)
  deformation_gradient,  ///< follows F, which the body then stores (cpGIMP, CPDI)
  corners                ///< its corners ride the grid: the shape has `convect` (CPDI2)
};

/// SHAPE FUNCTION: which nodes a particle talks to, and how its domain moves.
///
/// A value that a body carries: parameters common to all its particles (the half size of their domains), or a mesh of
/// corners. It has
///   - `domain_motion`: one of DomainMotion. A shape that does not say how its domain moves is refused;
///   - `bytes<Space>`: what it stores a particle beside the body's fields;
///   - `max_nodes<Space>`: the size of the largest stencil;
///   - `stencil(body, p, grid, out)`: w_Ip and grad w_Ip; sum w = 1, sum grad w = 0, sum w x_I = x and
///     sum x_I (x) grad w_I = 1 wherever the domain lies inside the grid;
///   - `reach(body, p)`: the half extent of its domain along each axis, m;
///   - `permute(order)`: follows a reordering of the particles.
///   - for DomainMotion::corners: `convect(body, velocity, dt)` with the velocities of its corners, which returns the
///   first
///     particle whose domain has inverted, or body.size(), and `corner_stencil(p, out)`;
///   - optional `check(body, grid)`: throws Error before the first step when its parameters are not fit for work.
template <class S>
concept ShapeFunction = std::default_initializable<S> && requires(S shape, std::span<const std::uint32_t> order) {
  { S::domain_motion } -> std::convertible_to<DomainMotion>;
  shape.permute(order);
};

}  // namespace mpm
