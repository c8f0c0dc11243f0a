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
#pragma omp parallel for schedule(static) reduction(min : limit) if (chunks.worth_threads())
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
  V unsound{0};  ///< NaN where one of them was no finite number

  template <class S, class B>
  void raise(const std::array<B, S::dimension>& b, const V& radius) {
    V sum(0), most(0);
    for (const B& k : b) sum += V(k), most = max(most, V(k));
    if constexpr (S::hoop) {
      const V hoop = V(1) / (radius * radius);
      sum += hoop, most = max(most, hoop);
    }
    shear = max(shear, S::dimension == 1 ? V(2) * most : max(V(2) * most, sum));
    lambda = max(lambda, sum);
    unsound += V(0) * sum;
  }
};

/// sum w'^2/w along each axis, 1/cell^2, from its modes.
template <class V, int K, std::size_t D>
[[gnu::always_inline]] inline void axis_stiffness(const std::array<AxisModes<V, K>, D>& modes, std::array<V, D>& b) {
  const V least(negligible_weight<typename V::Scalar>);
  shapes::unrolled<int(D)>([&](auto d) __attribute__((always_inline)) {
    const AxisModes<V, K>& m = modes[d];
    const auto part = [&](const V& w, const V& dw) __attribute__((always_inline)) {
      return select(w > least, dw * dw, V(0));
    };
    V weight = m.weight[0], slope = m.slope[0];
    V over = part(weight, slope), under = max(weight, least);  // a fraction: a division takes longer than the rest
    const auto add = [&](const V& w, const V& dw) __attribute__((always_inline)) {
      const V sound = max(w, least);
      over = over * sound + part(w, dw) * under;
      under *= sound;
    };
    shapes::unrolled<AxisModes<V, K>::stored - 1>([&](auto k) __attribute__((always_inline)) {
      add(m.weight[k + 1], m.slope[k + 1]);
      weight += m.weight[k + 1], slope += m.slope[k + 1];
    });
    if constexpr (K > 2) add(V(1) - weight, slope);  // the anchor's
    b[d] = over / under;
  });
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

/// What the grid is to a register of particles, 1/cell^2, as in grid_stiffness, from their modes. Returns false where
/// these do not serve.
template <class Body, class S, class V, int K>
[[gnu::always_inline]] inline bool register_stiffness(const std::array<AxisModes<V, K>, S::dimension>& modes,
                                                      const Grid<S>& grid, std::array<V, S::dimension>& b) {
  if constexpr (continues_linearly<typename Body::Shape>)
    for (int d = 0; d < S::dimension; ++d) {
      const auto low = modes[std::size_t(d)].anchor - shapes::nodes_before<K>;
      if (any_of((low < 0) | (low > grid.cells(d) + 1 - K))) return false;
    }
  axis_stiffness(modes, b);
  return true;
}
template <class Body, class S, class V>
[[gnu::always_inline]] inline bool register_stiffness(const Body& body, std::size_t p, const Grid<S>& grid,
                                                      std::array<V, S::dimension>& b) {
  using Shape = typename Body::Shape;
  if constexpr (HasModes<Body>) {
    std::array<AxisModes<V, Shape::axis_nodes>, S::dimension> modes;
    return body.shape.modes(body, p, grid, coordinates(body, p, grid), modes) &&
           register_stiffness<Body>(modes, grid, b);
  } else if constexpr (HasDomainModes<Body>) {
    DomainModes<V> modes;
    const bool fit = body.shape.domain_modes(body, p, grid, modes);
    b = domain_stiffness(modes);
    return fit;
  } else {
    return false;
  }
}
/// Raises `stiffness` to that of a register of particles, of which `valid` are meant: from `find(b)`, as above, or from
/// their stencils where it returns false.
template <class Body, class S, class V, class F>
[[gnu::always_inline]] inline void raise_stiffness(GridStiffness<V>& stiffness, const Body& body, std::size_t p,
                                                   int valid, const Grid<S>& grid, const F& find) {
  std::array<V, S::dimension> b;
  if (find(b)) [[likely]] {
    V radius = V::load(body.x(0) + p);
    for (V& k : b) k *= V(grid.inverse_cell() * grid.inverse_cell());
    if (valid < V::size) {
      const auto meant = first_lanes<V>(valid);
      for (V& k : b) k = select(meant, k, V(0));
      radius = select(meant, radius, V(radius[0]));
    }
    stiffness.template raise<S>(b, radius);
  } else {
    for (std::size_t q = p; q < p + std::size_t(std::min(V::size, valid)); ++q)
      stiffness.template raise<S>(grid_stiffness<S>(make_stencil(body, q, grid)), V(body.x(0)[q]));
  }
}
/// Stiffness of the grid to a chunk of particles.
template <class Body, class S, class V = typename Body::Lane>
GridStiffness<V> chunk_stiffness(const Body& body, std::size_t first, int count, const Grid<S>& grid) {
  GridStiffness<V> stiffness;
  for (int l = 0; l < count; l += V::size) {
    const std::size_t p = first + std::size_t(l);
    raise_stiffness(stiffness, body, p, count - l, grid, [&](auto& b) { return register_stiffness(body, p, grid, b); });
  }
  return stiffness;
}
template <class T, int N>
GridStiffness<T> over_lanes(const GridStiffness<Lanes<T, N>>& b) {
  return {largest(b.shear), largest(b.lambda), total(b.unsound)};
}

/// 1/dt^2 of the largest stable step of a chunk of particles, by lane, from its limits and the stiffness of the grid to
/// it: Irons' bound, abs(grad v) dt < 0.1 and abs(v) dt < h / 2. NaN if there is none.
template <class V, class B, class Scalar = typename V::Scalar>
V inverse_square_step(const StepLimits<Scalar>& l, const GridStiffness<B>& b, Scalar cell) {
  const Scalar pace = 2 * l.speed / cell;
  return larger_or_nan(V(Scalar(0.25)) * (V(l.shear) * V(b.shear) + V(l.lambda) * V(b.lambda)) + V(b.unsound),
                       V(larger_or_nan(100 * l.rate, pace * pace)));
}

/// The largest of such, of which infinity stands for NaN.
template <class V>
auto largest_or_infinite(const V& a) {
  const auto q = largest(a);
  return q < std::numeric_limits<decltype(q)>::infinity() ? q : std::numeric_limits<decltype(q)>::infinity();
}

}  // namespace detail

/// The same from the limits that the last step left for every chunk, and the stiffness of the grid to each,
/// `stiffness(first, count)`; chunks of which they are not known are looked at plainly. Moduli, rates and speeds are
/// those at the end of the last step, the largest of a chunk.
template <class Body, class S, class Stiffness, class Scalar = typename S::Scalar>
Scalar stable_step(const Body& body, const ChunkList& chunks, const Grid<S>& grid,
                   const std::vector<StepLimits<Scalar>>& limits, const Stiffness& stiffness) {
  using V = typename Body::Lane;
  Scalar inverse_square = std::numeric_limits<Scalar>::min(), plain = std::numeric_limits<Scalar>::max();
  const std::int64_t count = std::int64_t(chunks.size());
#pragma omp parallel reduction(max : inverse_square) reduction(min : plain) if (chunks.worth_threads())
  {
    V own(0);
#pragma omp for schedule(static) nowait
    for (std::int64_t k = 0; k < count; ++k) {
      const std::size_t first = chunks.first(std::size_t(k));
      const int size = chunks.count(std::size_t(k));
      const StepLimits<Scalar>& l = limits[first / chunk_size];
      if (l.known) {
        own = larger_or_nan(own, detail::inverse_square_step<V>(l, stiffness(first, size), grid.cell()));
      } else {
        for (std::size_t p = first; p < first + std::size_t(size); ++p)
          plain = std::min(plain, stable_step(body, p, grid));
      }
    }
    inverse_square = std::max(inverse_square, detail::largest_or_infinite(own));
  }
  return std::min(plain, 1 / std::sqrt(inverse_square));
}

}  // namespace mpm
