// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/mpm.hpp>
#include <benchmark/benchmark.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

// The block that every kernel is timed on, and the arithmetic that its transfers ask for.
namespace kernels {

using namespace mpm;

/// Where particles lie, and in which order they come.
enum class Layout : std::int64_t {
  regular,   ///< cells filled alike, numbered along the mesh
  jittered,  ///< each moved by up to a quarter of a cell
  shuffled,  ///< regular, numbered at random
  drifted    ///< regular, and since it was sorted moved by a fifth of a cell
};

/// Cells along the edge of a block of about `particles`.
template <class S>
int cells_for(int per_edge, double particles) {
  return std::max(1, int(std::pow(particles, 1. / S::dimension) / per_edge));
}

/// A block of `cells` cells of 1 m a side, two cells from the grid's edge, moving a little.
template <class Shape, class Law, class S>
Body<Shape, Law, S> block(int cells, int per_edge, Layout layout, const Law& law) {
  using Scalar = typename S::Scalar;
  Body<Shape, Law, S> body("block", {}, law);
  const Vector<S> lower = Vector<S>::Constant(2), upper = Vector<S>::Constant(Scalar(2 + cells));
  fill(body, lower, upper, Scalar(1) / Scalar(per_edge));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-.25, .25);
  constexpr bool by_corners = Shape::domain_motion == DomainMotion::corners;
  for (std::size_t p = 0; p < body.size(); ++p)
    for (int d = 0; d < S::dimension; ++d) {
      if (layout == Layout::jittered && !by_corners) body.x(d)[p] += Scalar(offset(random));
      body.v(d)[p] = Scalar(1e-3 * std::sin(double(body.x(d)[p])));
    }
  if constexpr (by_corners)
    if (layout == Layout::jittered)
      for (auto& x : body.shape.corner)
        for (auto& y : x) y += Scalar(.4 * offset(random) / per_edge);
  if (layout == Layout::shuffled) {
    std::vector<std::uint32_t> order(body.size());
    std::iota(order.begin(), order.end(), std::uint32_t(0));
    std::shuffle(order.begin(), order.end(), random);
    body.permute(order);
  }
  return body;
}

/// Operations that the transfers' formulas ask of a particle in one step, law left out: weights as products of the
/// axes', momentum, mass and forces to the nodes of its stencil, velocity, acceleration and velocity gradient back. The
/// stencils are those of this body; what a kernel saves by sharing, or spends on lanes it throws away, is not counted.
template <class Shape, class Law, class S>
double transfer_flops(const Body<Shape, Law, S>& body, const Grid<S>& grid) {
  constexpr int d = S::dimension;
  double nodes = 0;
  for (std::size_t p = 0; p < body.size(); ++p) nodes += make_stencil(body, p, grid).size();
  constexpr double weights = (d + 1) * (d - 1), to_nodes = 2 + 2 * d + 2 * d * d, back = 4 * d + 2 * d * d;
  return (weights + to_nodes + back) * nodes / double(body.size());
}

}  // namespace kernels
