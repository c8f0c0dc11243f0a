// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/relax.hpp>
#include <algorithm>
#include <cmath>
#include "../law.hpp"

namespace mpm::atlas {

/// The shear of Cook's membrane: on the last column of particles, shared out by mass.
struct EndLoad {
  double from = 0;          ///< x beyond which it acts, m
  double acceleration = 0;  ///< along y, m/s2
  template <class Body>
  Vector<PlaneStrain<>> operator()(const Body& body, std::size_t p, double) const {
    return {0, body.x(0)[p] > from ? acceleration : 0};
  }
};

/// Cook's membrane (Cook 1974): a tapered panel, (0, 0), (48, 44), (48, 60), (0, 44) m, clamped on the left, sheared by
/// a small total load on the right, in plane strain. Deflection of the middle of the right side over that of finite
/// elements, Q1 with mean dilatation on 200 x 200 elements, 21.94 F/E at nu .3 and 18.52 F/E at .499.
struct Cook {
  double poisson = .499;
  double cell = 4;   ///< m
  int per_edge = 2;  ///< particles a cell edge
};

template <class Shape>
double cook(const Cook& o) {
  using S = PlaneStrain<>;
  constexpr double young = 1e6, density = 1, load = 1;
  const double spacing = o.cell / o.per_edge, reference = (o.poisson < .4 ? 21.94 : 18.52) * load / young;
  Body<Shape, Law, S> panel{"panel", {}, {{.density = density, .young = young, .poisson = o.poisson}}};
  fill(panel, {0, 0}, {48, 60}, spacing,
       [](const Vector<S>& x) { return x[1] > 44. / 48 * x[0] && x[1] < 44 + 16. / 48 * x[0]; });
  const double last = 48 - spacing;
  double mass = 0;
  for (std::size_t p = 0; p < panel.size(); ++p) {
    if (panel.x(0)[p] > last) mass += panel.mass()[p];
    for (int d = 0; d < 2; ++d) panel.history(d)[p] = panel.x(d)[p];
  }
  Solver<Shape, Law, DynamicRelaxation<>, S, EndLoad> solver{
      Grid<S>{{0, -o.cell}, o.cell, {int(48 / o.cell) + 2, int(60 / o.cell) + 3}}, std::move(panel)};
  solver.boundary.face(0, 0) = Fixed<S>{};
  solver.body_force = {last, load / mass};
  relax(solver, {.tolerance = 1e-5, .max_steps = 100000});
  const auto& body = solver.body();
  double moved = 0, weight = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const auto X = problems::origin(body, p);
    if (X[0] < last || std::abs(X[1] - 52) > spacing) continue;
    moved += body.mass()[p] * (body.x(1)[p] - X[1]), weight += body.mass()[p];
  }
  return moved / weight / reference;
}

}  // namespace mpm::atlas
