// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/gather.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

namespace mpm {

/// Eigenvalues of G_p = sum_I grad w_I (x) grad w_I / w_I, 1/m2: how stiff the grid is to one particle.
///
/// A node that stands twice in a stencil counts as two, which can only overestimate it. One whose weight is below 1e-9
/// of the particle is left out: its share of the bound is the small-mass limit of the linear shape. A negative weight,
/// of a concave quadrilateral, counts by its size.
template <class S, class Out>
std::array<typename S::Scalar, S::dimension> grid_stiffness(const Out& stencil) {
  using Scalar = typename S::Scalar;
  constexpr int dimension = S::dimension;
  Scalar G[dimension][dimension] = {};
  for (const auto& [I, w, grad] : stencil) {
    if (std::abs(w) < Scalar(1e-9)) continue;
    const Scalar inverse = 1 / std::abs(w);
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < dimension; ++j) G[i][j] += grad[i] * grad[j] * inverse;
  }
  if constexpr (dimension == 1) {
    return {G[0][0]};
  } else if constexpr (dimension == 2) {
    const Scalar mean = (G[0][0] + G[1][1]) / 2, half = (G[0][0] - G[1][1]) / 2;
    const Scalar radius = std::sqrt(half * half + G[0][1] * G[0][1]);
    return {mean + radius, mean - radius};
  } else {
    return {G[0][0], G[1][1], G[2][2]};  // product bases: diagonal
  }
}

/// Largest stable step of particle p: Irons' bound 2 / sqrt(l_max(C : diag(b)) / rho) with the law's tangent, a bound
/// of the eigenvalues of its normal block by 2 G max b + lambda sum b (exact for equal b).
template <class S, class Out>
typename S::Scalar irons_step(const Out& stencil, const Moduli<typename S::Scalar>& C, typename S::Scalar density,
                              typename S::Scalar radius) {
  using Scalar = typename S::Scalar;
  const auto b = grid_stiffness<S>(stencil);
  const Scalar lambda = std::max(Scalar(0), C.longitudinal - 2 * C.shear);
  Scalar sum = 0, largest = 0;
  for (Scalar k : b) sum += k, largest = std::max(largest, k);
  if constexpr (S::hoop) sum += 1 / (radius * radius), largest = std::max(largest, 1 / (radius * radius));
  const Scalar shear = S::dimension == 1 ? 2 * C.shear * largest : C.shear * std::max(2 * largest, sum);
  return 2 / std::sqrt((shear + lambda * sum) / density);
}

/// The step that is safe for every particle of the body: Irons' bound with the tangent moduli, reduced for bulk
/// viscosity, and abs(v) dt < h / 2, abs(grad v) dt < 0.1.
template <class Body, class S>
typename S::Scalar stable_step(const Body& body, const Grid<S>& grid) {
  using Scalar = typename S::Scalar;
  Scalar limit = std::numeric_limits<Scalar>::max();
  const std::int64_t count = std::int64_t(body.size());
#pragma omp parallel for schedule(static) reduction(min : limit)
  for (std::int64_t q = 0; q < count; ++q) {
    const std::size_t p = std::size_t(q);
    const auto stencil = make_stencil(body, p, grid);
    const auto moduli = body.law.tangent(body.state(p), body.relative_volume(p));
    const Scalar density = body.mass()[p] / body.volume()[p];
    Scalar dt = irons_step<S>(stencil, moduli, density, body.x(0)[p]);
    const auto L = velocity_gradient<S>(stencil, grid.velocity, body.x(0)[p]);
    if constexpr (requires { body.law.viscosity; })
      dt *= body.law.viscosity.step_factor(std::sqrt(moduli.longitudinal / density), trace(L), grid.cell());
    const Scalar gradient = std::sqrt(inner(symmetric(L), symmetric(L)));
    dt = std::min(dt, Scalar(0.1) / std::max(gradient, std::numeric_limits<Scalar>::min()));
    for (int d = 0; d < S::dimension; ++d)
      dt = std::min(dt, grid.cell() / 2 / std::max(std::abs(body.v(d)[p]), std::numeric_limits<Scalar>::min()));
    limit = std::min(limit, std::isfinite(dt) ? dt : Scalar(0));
  }
  return limit;
}

}  // namespace mpm
