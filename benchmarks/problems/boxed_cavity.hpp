// SPDX-License-Identifier: MIT
#pragma once
#include "cavity.hpp"
#include <numbers>

// The cavity of cavity.hpp where no quadrilaterals are to be had: boxes in the plane, or in a slice of the block one
// cell thick.
namespace mpm::problems {

/// Rock that the pressure acts on: the innermost ring of particles. A law of its own tells it from the rest.
struct WallRock : Hypoelastic {};

/// The pressure on the wall as a force on the innermost ring, which stands half a particle behind the wall: an error of
/// first order in the particle's size over the radius.
template <Space S>
struct WallPressure {
  double pressure = 0;  ///< Pa
  double arc = 0;       ///< of the wall, a particle, m
  double depth = 1;     ///< of a particle along the hole, m
  template <class Body>
  Vector<S> operator()(const Body& body, std::size_t p, double) const {
    Vector<S> b = Vector<S>::Zero();
    if constexpr (std::is_same_v<typename Body::Law, WallRock>) {
      const double x = double(body.x(0)[p]), y = double(body.x(1)[p]);
      const double push = pressure * arc * depth / double(body.mass()[p]) / std::hypot(x, y);
      b[0] = typename S::Scalar(push * x), b[1] = typename S::Scalar(push * y);
    }
    return b;
  }
};

/// A quarter of the block, on boxes at the centres of the quadrilaterals of cavity() with their areas. In `Spatial` a
/// slice one cell thick between rollers. Reads no peak on the wall.
template <class S, class Integrator = Usl>
CavityOutcome boxed_cavity(const CavityOptions& options, const Integrator& integrator = {}) {
  static_assert(S::dimension > 1, "problems::boxed_cavity: for one dimension see radial_cavity");
  constexpr bool slice = S::dimension == 3;
  const double cell = hole / options.cells, size = cell / options.per_edge;
  const auto block = holed_block(options.side, options.cells, options.per_edge);
  const auto mesh = block.mesh();
  const auto quads = geometry::make_body("rock", mesh, granite_elastic());

  Body<Ugimp, Hypoelastic, S> rock("rock", {}, granite_elastic());
  Body<Ugimp, WallRock, S> wall("wall", {}, {granite_elastic()});
  rock.shape.half_size.fill(size / 2), wall.shape.half_size.fill(size / 2);
  const double depth = slice ? size : 1;
  for (std::size_t p = 0; p < quads.size(); ++p)
    for (int layer = 0; layer < (slice ? options.per_edge : 1); ++layer) {
      Vector<S> x;
      x[0] = quads.x(0)[p], x[1] = quads.x(1)[p];
      if constexpr (slice) x[2] = (layer + .5) * size;
      const auto add = [&](auto& body) { body.add(x, quads.volume()[p] * depth, Vector<S>::Zero()); };
      if (p < mesh.wall.size()) {  // the rings come first, from the wall outwards
        add(wall);
      } else {
        add(rock);
      }
    }
  const int half = int(std::lround(options.side * options.cells));
  std::array<int, S::dimension> cells;
  cells.fill(half);
  if constexpr (slice) cells[2] = 1;
  Solver<Ugimp, PerBody<Hypoelastic, WallRock>, Integrator, S, WallPressure<S>> solver(
      Grid<S>(Vector<S>::Zero(), cell, cells), std::move(rock), std::move(wall));
  solver.integrator = integrator;
  for (int d = 0; d < 2; ++d) solver.boundary.face(d, 0) = Rollers<S>{};
  if constexpr (slice)
    for (int side : {0, 1}) solver.boundary.face(2, side) = Rollers<S>{};
  solver.body_force = {.arc = std::numbers::pi / 2 * hole / double(mesh.wall.size()), .depth = depth};
  auto outcome = detail::blast(solver, options, {}, [&](double p) { solver.body_force.pressure = p; });
  outcome.particles += std::int64_t(solver.template body<1>().size());
  return outcome;
}

}  // namespace mpm::problems
