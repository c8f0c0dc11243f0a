// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/domain_weights.hpp>
#include <mpm/passes/quad_weights.hpp>
#include <mpm/passes/update_stress.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

// The largest step that is stable.
namespace mpm {

/// Share of a particle below which a node is left out of Irons' bound: 1e-9, and no less than round-off leaves right.
template <class Scalar>
inline constexpr Scalar negligible_weight = std::max(Scalar(1e-9), 16 * std::numeric_limits<Scalar>::epsilon());

/// Eigenvalues of G_p = sum_I grad w_I (x) grad w_I / w_I, 1/m2: how stiff the grid is to one particle.
///
/// A node that stands twice in a stencil counts as two, which can only overestimate it. One of negligible weight is
/// left out: its share of the bound is the small-mass limit of the linear shape. A negative weight, of a concave
/// quadrilateral, counts by its size.
template <class S, class Out>
std::array<typename S::Scalar, S::dimension> grid_stiffness(const Out& stencil) {
  using Scalar = typename S::Scalar;
  constexpr int dimension = S::dimension;
  Scalar G[dimension][dimension] = {};
  for (const auto& [I, w, grad] : stencil) {
    if (std::abs(w) < negligible_weight<Scalar>) continue;
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

/// The step that is safe for particle p: Irons' bound with the tangent moduli, reduced for bulk viscosity, and
/// abs(v) dt < h / 2, abs(grad v) dt < 0.1; zero if there is none.
template <class Body, class S>
typename S::Scalar stable_step(const Body& body, std::size_t p, const Grid<S>& grid) {
  using Scalar = typename S::Scalar;
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
  return std::isfinite(dt) ? dt : Scalar(0);
}
/// The least of the steps that f(first, count) allows the chunks.
template <class Scalar, class F>
Scalar least_step(const ChunkList& chunks, const F& f) {
  Scalar limit = std::numeric_limits<Scalar>::max();
  const std::int64_t count = std::int64_t(chunks.size());
#pragma omp parallel for schedule(static) reduction(min : limit)
  for (std::int64_t k = 0; k < count; ++k)
    limit = std::min(limit, f(chunks.first(std::size_t(k)), chunks.count(std::size_t(k))));
  return limit;
}
/// The step that is safe for every particle of the chunks, particle by particle: the plain form.
template <class Body, class S>
typename S::Scalar stable_step(const Body& body, const ChunkList& chunks, const Grid<S>& grid) {
  using Scalar = typename S::Scalar;
  return least_step<Scalar>(chunks, [&](std::size_t first, int count) {
    Scalar limit = std::numeric_limits<Scalar>::max();
    for (std::size_t p = first; p < first + std::size_t(count); ++p)
      limit = std::min(limit, stable_step(body, p, grid));
    return limit;
  });
}

namespace detail {

/// What the stencils of a chunk of particles make of moduli: the largest of max(2 max b, sum b), which goes with the
/// shear modulus, and of sum b, which goes with lambda, 1/m2; see irons_step. With lanes for V, the largest by lane.
template <class V>
struct GridStiffness {
  V shear{0}, lambda{0};

  template <class S>
  void raise(const std::array<V, S::dimension>& b, const V& radius) {
    V sum(0), most(0);
    for (const V& k : b) sum += k, most = max(most, k);
    if constexpr (S::hoop) {
      const V hoop = V(1) / (radius * radius);
      sum += hoop, most = max(most, hoop);
    }
    shear = larger_or_nan(shear, S::dimension == 1 ? V(2) * most : max(V(2) * most, sum));
    lambda = larger_or_nan(lambda, sum);
  }
};

/// sum w'^2/w of one axis, 1/cell^2, from its modes.
template <class V, int K>
V axis_stiffness(const AxisModes<V, K>& m) {
  const V least(negligible_weight<typename V::Scalar>);
  const auto part = [&](const V& w, const V& d) { return select(w > least, d * d / max(w, least), V(0)); };
  V sum(0), weight(0), slope(0);
  for (std::size_t k = 0; k < m.weight.size(); ++k) {
    sum += part(m.weight[k], m.slope[k]);
    weight += m.weight[k], slope += m.slope[k];
  }
  return K == 2 ? sum : sum + slope * slope / (V(1) - weight);  // the anchor's
}

/// Eigenvalues of G_p, 1/cell^2, of a domain in modes; see grid_stiffness.
template <class V>
[[gnu::always_inline]] inline std::array<V, 2> domain_stiffness(DomainModes<V> m) {
  shapes::all_to_nodes<2, 3>(m.weight);
  for (V* slope : m.slope) shapes::all_to_nodes<2, 3>(slope);
  const V least(negligible_weight<typename V::Scalar>);
  V xx(0), yy(0), xy(0);
  for (int k = 0; k < m.modes; ++k) {
    const V w = abs(m.weight[k]), inverse = select(w > least, V(1) / max(w, least), V(0));
    const V gx = m.slope[0][k], gy = m.slope[1][k];
    xx += gx * gx * inverse, yy += gy * gy * inverse, xy += gx * gy * inverse;
  }
  const V mean = V(0.5) * (xx + yy), half = V(0.5) * (xx - yy), radius = sqrt(half * half + xy * xy);
  return {mean + radius, mean - radius};
}

/// What the grid is to a register of particles, 1/cell^2, as in grid_stiffness. Returns false where modes do not serve.
template <class Body, class S, class V>
[[gnu::always_inline]] inline bool register_stiffness(const Body& body, std::size_t p, const Grid<S>& grid,
                                                      std::array<V, S::dimension>& b) {
  using Shape = typename Body::Shape;
  if constexpr (HasModes<Body>) {
    constexpr int K = Shape::axis_nodes;
    std::array<AxisModes<V, K>, S::dimension> modes;
    if (!body.shape.modes(body, p, grid, coordinates(body, p, grid), modes)) return false;
    if constexpr (continues_linearly<Shape>)
      for (int d = 0; d < S::dimension; ++d) {
        const auto low = modes[std::size_t(d)].anchor - shapes::nodes_before<K>;
        if (any_of((low < 0) | (low > grid.cells(d) + 1 - K))) return false;
      }
    for (std::size_t d = 0; d < b.size(); ++d) b[d] = axis_stiffness<V, K>(modes[d]);
    return true;
  } else if constexpr (HasDomainModes<Body>) {
    DomainModes<V> modes;
    const bool fit = body.shape.domain_modes(body, p, grid, modes);
    b = domain_stiffness(modes);
    return fit;
  } else if constexpr (std::is_same_v<Shape, CpdiQuad> && std::is_same_v<typename S::Scalar, double>) {
    DomainModes<V> modes;
    const bool fit = quad_modes(body, p, V::size, grid, modes);
    b = domain_stiffness(modes);
    return fit;
  } else {
    return false;
  }
}

/// Stiffness of the grid to a chunk of particles, from their modes, or from their stencils where modes do not serve.
template <class Body, class S, class Scalar = typename S::Scalar>
GridStiffness<Scalar> chunk_stiffness(const Body& body, std::size_t first, int count, const Grid<S>& grid) {
  GridStiffness<Scalar> stiffness;
  const auto plainly = [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      stiffness.template raise<S>(grid_stiffness<S>(make_stencil(body, p, grid)), body.x(0)[p]);
  };
  using V = typename Body::Lane;
  const V per_square(grid.inverse_cell() * grid.inverse_cell());
  GridStiffness<V> by_lane;
  for (int l = 0; l < count; l += V::size) {
    const std::size_t p = first + std::size_t(l);
    std::array<V, S::dimension> b;
    if (count - l < V::size || !register_stiffness(body, p, grid, b)) {
      plainly(p, p + std::size_t(std::min(V::size, count - l)));
      continue;
    }
    for (V& k : b) k *= per_square;
    by_lane.template raise<S>(b, V::load(body.x(0) + p));
  }
  stiffness.shear = larger_or_nan(stiffness.shear, largest(by_lane.shear));
  stiffness.lambda = larger_or_nan(stiffness.lambda, largest(by_lane.lambda));
  return stiffness;
}

}  // namespace detail

/// The same from the limits that the last step left for every chunk, and the stiffness of the grid to each,
/// `stiffness(first, count)`; chunks of which they are not known are looked at plainly. Moduli, rates and speeds are
/// those at the end of the last step, the largest of a chunk.
template <class Body, class S, class Stiffness, class Scalar = typename S::Scalar>
Scalar stable_step(const Body& body, const ChunkList& chunks, const Grid<S>& grid,
                   const std::vector<StepLimits<Scalar>>& limits, const Stiffness& stiffness) {
  Scalar elastic = 0, rate = 0, speed = 0, plain = std::numeric_limits<Scalar>::max();
  const std::int64_t count = std::int64_t(chunks.size());
#pragma omp parallel for schedule(static) reduction(max : elastic, rate, speed) reduction(min : plain)
  for (std::int64_t k = 0; k < count; ++k) {
    const std::size_t first = chunks.first(std::size_t(k));
    const int size = chunks.count(std::size_t(k));
    const StepLimits<Scalar>& l = limits[first / chunk_size];
    if (!l.known) {
      for (std::size_t p = first; p < first + std::size_t(size); ++p)
        plain = std::min(plain, stable_step(body, p, grid));
      continue;
    }
    const auto b = stiffness(first, size);
    const Scalar stiff = l.shear * b.shear + l.lambda * b.lambda;
    if (!std::isfinite(stiff + l.rate + l.speed)) plain = 0;
    elastic = std::max(elastic, stiff), rate = std::max(rate, l.rate), speed = std::max(speed, l.speed);
  }
  constexpr Scalar tiny = std::numeric_limits<Scalar>::min();
  return std::min({plain, 2 / std::sqrt(std::max(elastic, tiny)), Scalar(0.1) / std::sqrt(std::max(rate, tiny)),
                   grid.cell() / 2 / std::max(speed, tiny)});
}

}  // namespace mpm
