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

/// The stiffness of a grid whose G_p has these eigenvalues, from shares that are the particles' own: with them the hoop
/// stands alone.
template <class S, class V>
[[gnu::always_inline]] inline GridStiffness<V> stiffness_of(const std::array<V, S::dimension>& b, const V& radius) {
  GridStiffness<V> stiffness;
  for (const V& k : b) stiffness.volume += k, stiffness.most = max(stiffness.most, k);
  if constexpr (S::hoop) {
    const V hoop = V(1) / (radius * radius);
    stiffness.volume += hoop, stiffness.most = max(stiffness.most, hoop);
  }
  return stiffness;
}

/// sum w'^2/w along each axis, 1/cell^2, from its modes.
template <class V, int K, std::size_t D>
[[gnu::always_inline]] inline void axis_stiffness(const std::array<AxisModes<V, K>, D>& modes, std::array<V, D>& b) {
  const V steepest(steepest_slope<typename V::Scalar>);
  shapes::unrolled<int(D)>([&](auto d) __attribute__((always_inline)) {
    const AxisModes<V, K>& m = modes[d];
    V over(0), under(1);  // a fraction: a division takes longer than the rest
    const auto add = [&](const V& w, const V& dw) __attribute__((always_inline)) {
      const auto fades = abs(dw) < steepest * w;
      const V sound = select(fades, w, V(1));
      over = over * sound + select(fades, dw * dw, V(0)) * under;
      under *= sound;
    };
    V weight(0), slope(0);
    shapes::unrolled<AxisModes<V, K>::stored>([&](auto k) __attribute__((always_inline)) {
      add(m.weight[k], m.slope[k]);
      weight += m.weight[k], slope += m.slope[k];
    });
    if constexpr (K > 2) add(V(1) - weight, slope);  // the anchor's
    b[d] = over / under;
  });
}

/// Eigenvalues of G_p, 1/cell^2, of a domain in modes; see GridStiffness.
template <class V>
[[gnu::always_inline]] inline std::array<V, 2> domain_stiffness(DomainModes<V> m) {
  shapes::all_to_nodes<2, 3>(m.weight);
  for (V* slope : m.slope) shapes::all_to_nodes<2, 3>(slope);
  const V least(std::numeric_limits<typename V::Scalar>::min()), steepest(steepest_slope<typename V::Scalar>);
  V xx(0), yy(0), xy(0);
  for (int k = 0; k < m.modes; ++k) {
    const V w = abs(m.weight[k]), inverse = V(1) / max(w, least);
    const V gx = select(abs(m.slope[0][k]) < steepest * w, m.slope[0][k], V(0));
    const V gy = select(abs(m.slope[1][k]) < steepest * w, m.slope[1][k], V(0));
    xx += gx * gx * inverse, yy += gy * gy * inverse, xy += gx * gy * inverse;
  }
  const V mean = V(0.5) * (xx + yy), half = V(0.5) * (xx - yy), radius = sqrt(half * half + xy * xy);
  return {mean + radius, mean - radius};
}

/// Eigenvalues of G_p, 1/cell^2, of a register of particles from their modes. Returns false where these do not serve.
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
    stiffness.raise(stiffness_of<S>(b, radius));
  } else {
    for (std::size_t q = p; q < p + std::size_t(std::min(V::size, valid)); ++q)
      stiffness.raise(grid_stiffness<S>(make_stencil(body, q, grid), body.x(0)[q], grid.cell(), OwnShare{}));
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
  return {largest(b.most), largest(b.volume), total(b.unsound)};
}

/// 1/dt^2 of the largest stable step of a chunk of particles, by lane, from its limits and the stiffness of the grid to
/// it: Irons' bound, abs(grad v) dt < 0.1 and abs(v) dt < h / 2. NaN if there is none.
template <class V, class B, class Scalar = typename V::Scalar>
V inverse_square_step(const StepLimits<Scalar>& l, const GridStiffness<B>& b, Scalar cell) {
  const Scalar pace = 2 * l.speed / cell;
  return larger_or_nan(V(mpm::inverse_square_step(B(l.lambda), B(l.shear), b) + b.unsound),
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
