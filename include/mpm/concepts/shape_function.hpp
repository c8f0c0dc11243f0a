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
///   - `reach(body, p, grid)`: the half extent along each axis, m, over which the grid's hats enter its weights: of its
///     domain, or of the box that makes a spline of a hat;
///   - `permute(order)`: follows a reordering of the particles;
///   - for DomainMotion::corners: `corner`, their positions; `corner_stencil(p, out)`: w_cp and grad w_cp on them;
///     `convect(body, velocity, dt, corners, particles)` with the velocities of the corners and the ChunkLists of those
///     that move, which returns the first particle whose domain has inverted, or body.size(); `pressure` on its
///     surface, of which `load_surface(add)` calls add(corner, force);
///   - optional, for the fast passes: `axis_nodes`, the number K of nodes along each axis, 2, 3 or 4, in every place
///     (unless the domain follows F), and `modes(body, p, grid, xi, out)`, the weights of a register of particles from
///     p on by axis, see shapes/modes.hpp; returns false where modes cannot give them and the plain stencil must;
///     `continues_linearly`, if nodes beyond a face stand for the continuation of those within;
///   - optional `static constexpr bool tangles = true`: its domains follow every shear, which a flow makes without end;
///     not for fluids in more than one dimension;
///   - optional `static constexpr bool mean_dilatation = true`: its particles share the rate of volume of their cell
///     (see MeanDilatation);
///   - optional `check(body, grid)`: throws Error before the first step when its parameters are not fit for work.
template <class S>
concept ShapeFunction = std::default_initializable<S> && requires(S shape, std::span<const std::uint32_t> order) {
  { S::domain_motion } -> std::convertible_to<DomainMotion>;
  shape.permute(order);
};

/// A shape whose domains tangle in a flow.
template <class S>
inline constexpr bool tangles = requires {
  requires S::tangles;
};

/// A shape whose particles share the rate of volume of their cell; see MeanDilatation.
template <class S>
inline constexpr bool mean_dilatation = requires {
  requires S::mean_dilatation;
};

}  // namespace mpm
