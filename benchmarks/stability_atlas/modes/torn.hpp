// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/mpm.hpp>

namespace mpm::atlas {

/// Share of the pairs of neighbours that share no node any more, and so do not feel each other: of a bar drawn out
/// evenly to a stretch, two particles a cell at first.
template <class Shape>
double torn(double stretch) {
  using S = Uniaxial<>;
  constexpr int particles = 60;
  using Bar = Body<Shape, Hypoelastic, S>;
  Bar bar{"bar", {}, {}};
  fill(bar, Vector<S>{0.0}, Vector<S>{particles / 2.0}, .5);
  for (std::size_t p = 0; p < bar.size(); ++p) {
    bar.x(0)[p] = 10 + (stretch + 1e-4) * bar.x(0)[p];
    if constexpr (Bar::stores_F) bar.store_F(p, {stretch + 1e-4, 0, 0, 0, 1, 0, 0, 0, 1});
  }
  const Grid<S> grid{Vector<S>{0.0}, 1, {int(stretch * particles / 2) + 20}};
  const auto meet = [&](std::size_t p) {
    for (const auto& a : make_stencil(bar, p, grid))
      for (const auto& b : make_stencil(bar, p + 1, grid))
        if (a.node == b.node && a.weight > 1e-12 && b.weight > 1e-12) return true;
    return false;
  };
  int count = 0;
  for (std::size_t p = 0; p + 1 < bar.size(); ++p) count += !meet(p);
  return double(count) / (particles - 1);
}

}  // namespace mpm::atlas
