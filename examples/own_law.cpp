// SPDX-License-Identifier: MIT
// A law of one's own, von_mises.hpp, at work: a copper cylinder hits a rigid wall (Taylor 1948).
#include "von_mises.hpp"
#include <algorithm>
#include <cstdio>

int main() {
  using Space = mpm::Axisymmetric<>;
  const double spacing = .4e-3;
  mpm::Body<mpm::Cpgimp, VonMises, Space> bar{"bar", {}, copper()};
  mpm::fill(bar, {0, 0}, {3.2e-3, 32.4e-3}, spacing, [](const auto&) { return true; }, {0, -227});

  mpm::Solver<mpm::Cpgimp, VonMises, mpm::Musl, Space> solver{mpm::Grid<Space>{{0, 0}, 2 * spacing, {16, 44}}, bar};
  solver.boundary.face(0, 0) = mpm::Rollers<Space>{};  // the axis
  solver.boundary.face(1, 0) = mpm::Rollers<Space>{};  // the wall
  solver.run(80e-6);

  const auto& after = solver.body();
  const double radius = *std::max_element(after.x(0), after.x(0) + after.size()) + spacing / 2;
  const double length = *std::max_element(after.x(1), after.x(1) + after.size()) + spacing / 2;
  const double strain = *std::max_element(after.history(0), after.history(0) + after.size());
  std::printf("after %.0f us: length %.2f mm, foot radius %.2f mm, largest plastic strain %.2f\n", 1e6 * solver.time,
              1e3 * length, 1e3 * radius, strain);
}
