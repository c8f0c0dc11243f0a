// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/update_stress.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

// The largest step that is stable.
namespace mpm {

/// Slope of a weight over the weight, by cell, beyond which Irons' bound leaves the slope out: the small-mass limit of
/// the linear shape, whose weight fades with its slope still one. Weights that fade with their slopes come there only
/// when they hardly touch the node.
template <class Scalar>
inline constexpr Scalar steepest_slope = 1 / std::max(Scalar(1e-9), 16 * std::numeric_limits<Scalar>::epsilon());

/// How stiff the grid is to particles, 1/m2. One that takes the mass m_pI of node I bounds the frequencies with
/// G_p = sum_I d_I (x) d_I m_p / m_pI, d = grad w, and w/r beside it where there is a hoop strain: 2 G times the
/// largest eigenvalue of G_p, and lambda times sum_I abs(d_I + e_r w/r)^2 m_p / m_pI. With lanes for V, the largest by
/// lane.
template <class V>
struct GridStiffness {
  V most{0};     ///< the largest eigenvalue, which goes with twice the shear modulus
  V volume{0};   ///< that sum, which goes with lambda
  V unsound{0};  ///< NaN where one of them was no finite number

  template <class B>
  void raise(const GridStiffness<B>& b) {
    most = max(most, V(b.most)), volume = max(volume, V(b.volume));
    unsound += V(0) * V(b.volume) + V(b.unsound);
  }
};

/// A particle's own share of its nodes, m_pI = m_p w_Ip: Irons' bound, a particle at a time. A negative weight, of a
/// concave quadrilateral, counts by its size.
struct OwnShare {
  /// m_p / m_pI
  auto operator()(const auto& entry) const { return 1 / std::abs(entry.weight); }
};

/// The stiffness of a grid of such cells to one particle at `radius`, with m_p / m_pI = over_share(entry). A node that
/// stands twice in a stencil counts as two, which can only overestimate it.
template <class S, class Out, class Share, class Scalar = typename S::Scalar>
GridStiffness<Scalar> grid_stiffness(const Out& stencil, Scalar radius, Scalar cell, const Share& over_share) {
  constexpr int D = S::dimension, rows = D + S::hoop;
  Scalar G[rows][rows] = {};
  for (const auto& entry : stencil) {
    const Scalar factor = over_share(entry);
    if (factor > std::numeric_limits<Scalar>::max()) continue;  // it does not touch the node
    Scalar d[rows];
    for (int i = 0; i < D; ++i) {
      const bool fades = std::abs(entry.gradient[i]) * cell < steepest_slope<Scalar> * std::abs(entry.weight);
      d[i] = fades ? entry.gradient[i] : 0;
    }
    if constexpr (S::hoop) d[D] = entry.weight / radius;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j <= i; ++j) G[i][j] += d[i] * d[j] * factor;
  }
  GridStiffness<Scalar> b{.most = G[0][0], .volume = G[0][0]};
  for (int k = 1; k < rows; ++k) {  // bordered by one row more: exact for two, a bound for three
    Scalar coupling = 0;
    for (int i = 0; i < k; ++i) coupling += G[k][i] * G[k][i];
    const Scalar mean = (b.most + G[k][k]) / 2, half = (b.most - G[k][k]) / 2;
    b.most = mean + std::sqrt(half * half + coupling);
    b.volume += G[k][k];
  }
  if constexpr (S::hoop) b.volume += 2 * G[D][0];
  return b;
}

/// 1/dt^2 of the largest stable step of particles in such a grid, with the moduli over the density: dt = 2/w with
/// w^2 = (2 G most + lambda volume) / rho, since 2 G abs(strain)^2 + lambda tr^2 is at most that with grad u for the
/// strain.
template <class V>
V inverse_square_step(const V& lambda, const V& shear, const GridStiffness<V>& b) {
  return V(0.25) * (V(2) * shear * b.most + lambda * b.volume);
}

/// The step that is safe for particle p: Irons' bound with the tangent moduli, reduced for bulk viscosity, and
/// abs(v) dt < h / 2, abs(grad v) dt < 0.1; zero if there is none.
template <class Body, class S>
typename S::Scalar stable_step(const Body& body, std::size_t p, const Grid<S>& grid) {
  using Scalar = typename S::Scalar;
  const auto stencil = make_stencil(body, p, grid);
  const auto moduli = body.law.tangent(body.state(p), body.relative_volume(p));
  const Scalar density = body.mass()[p] / body.volume()[p];
  const Scalar lambda = std::max(Scalar(0), moduli.longitudinal - 2 * moduli.shear);
  const auto stiffness = grid_stiffness<S>(stencil, body.x(0)[p], grid.cell(), OwnShare{});
  Scalar dt = 1 / std::sqrt(inverse_square_step(lambda / density, moduli.shear / density, stiffness));
  const auto L = velocity_gradient<S>(stencil, grid.velocity, body.x(0)[p]);
  if constexpr (requires { body.law.viscosity; })
    dt *= body.law.viscosity.step_factor(std::sqrt(moduli.longitudinal / density), trace(L), grid.cell());
  const Scalar gradient = std::sqrt(inner(symmetric(L), symmetric(L)));
  dt = std::min(dt, Scalar(0.1) / std::max(gradient, std::numeric_limits<Scalar>::min()));
  for (int d = 0; d < S::dimension; ++d)
    dt = std::min(dt, grid.cell() / 2 / std::max(std::abs(body.v(d)[p]), std::numeric_limits<Scalar>::min()));
  return std::isfinite(dt) ? dt : Scalar(0);
}
/// The step that is safe for every particle of the chunks, particle by particle: the plain form.
template <class Body, class S>
typename S::Scalar stable_step(const Body& body, const ChunkList& chunks, const Grid<S>& grid) {
  using Scalar = typename S::Scalar;
  return chunks.least(std::numeric_limits<Scalar>::max(), [&](std::size_t first, int count) {
    Scalar limit = std::numeric_limits<Scalar>::max();
    for (std::size_t p = first; p < first + std::size_t(count); ++p)
      limit = std::min(limit, stable_step(body, p, grid));
    return limit;
  });
}

}  // namespace mpm
