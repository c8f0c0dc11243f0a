// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/domain_weights.hpp>
#include <mpm/passes/quad_weights.hpp>
#include <mpm/passes/stable_step.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// The step of stable_step.hpp for registers of particles, and for chunks from their limits.
namespace mpm {

namespace detail {

/// The stiffness of a grid whose G_p has these eigenvalues, from shares that are the particles' own: with them the hoop
/// stands alone.
template <class S, class V>
[[gnu::always_inline]] inline GridStiffness<V> stiffness_of(const std::array<V, S::dimension>& b, const V& radius) {
  GridStiffness<V> stiffness{.most = b[0], .volume = b[0]};
  for (std::size_t d = 1; d < b.size(); ++d) stiffness.volume += b[d], stiffness.most = max(stiffness.most, b[d]);
  if constexpr (S::hoop) {
    const V hoop = V(1) / (radius * radius);
    stiffness.volume += hoop, stiffness.most = max(stiffness.most, hoop);
  }
  return stiffness;
}

/// sum w'^2/w along each axis, 1/cell^2, from its modes. Sums and quotients are kept as fractions, over/under, with one
/// division for all: it takes longer than the rest.
template <class V, int K, std::size_t D>
[[gnu::always_inline]] inline void axis_stiffness(const std::array<AxisModes<V, K>, D>& modes, std::array<V, D>& b) {
  using Scalar = typename V::Scalar;
  constexpr Scalar flattest = 1 / steepest_slope<Scalar>;
  std::array<V, D> under;
  shapes::unrolled<int(D)>([&](auto d) __attribute__((always_inline)) {
    const AxisModes<V, K>& m = modes[d];
    if constexpr (K == 2) {  // slopes of one: a weight that fades is left out
      const V left_out(1 / (flattest * flattest));
      const V low = select(m.weight[0] > V(flattest), m.weight[0], left_out);
      const V high = select(m.weight[1] > V(flattest), m.weight[1], left_out);
      b[d] = low + high, under[d] = low * high;
    } else {  // a weight below `least` loses its part, which the plain form has left out long before
      const V least(flattest * flattest / 32768);
      const V scale(sizeof(Scalar) == 4 ? 1 << 30 : 1);  // of both, or three axes' product is below what a float can be
      V weight = m.weight[0], slope = m.slope[0];
      b[d] = slope * slope * scale, under[d] = (weight + least) * scale;
      const auto add = [&](const V& w, const V& dw) __attribute__((always_inline)) {
        b[d] = b[d] * w + dw * dw * under[d], under[d] *= w;
      };
      for (std::size_t k = 1; k < AxisModes<V, K>::stored; ++k) {
        add(m.weight[k] + least, m.slope[k]);
        weight += m.weight[k], slope += m.slope[k];
      }
      add(V(1) - weight, slope);  // the anchor's
    }
  });
  V product = under[0];
  for (std::size_t d = 1; d < D; ++d) product *= under[d];
  V inverse = V(1) / product;  // of the under of this axis and of those below
  for (std::size_t d = D - 1; d > 0; --d) {
    V below = under[0];
    for (std::size_t e = 1; e < d; ++e) below *= under[e];
    b[d] *= below * inverse, inverse *= under[d];
  }
  b[0] *= inverse;
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

/// Marks those of the first `valid` particles whose stencils pass a face, where splines have other weights than these
/// modes.
template <class Body, class S, class V, int K>
[[gnu::always_inline]] inline void mark_beyond(const std::array<AxisModes<V, K>, S::dimension>& modes, int valid,
                                               const Grid<S>& grid, typename V::Integers& beyond) {
  if constexpr (continues_linearly<typename Body::Shape>) {
    typename V::Integers lane;
    for (int k = 0; k < V::size; ++k) lane[k] = k;
    for (int d = 0; d < S::dimension; ++d) {
      const auto low = modes[std::size_t(d)].anchor - shapes::nodes_before<K>;
      beyond |= (lane < valid) & ((low < 0) | (low > grid.cells(d) + 1 - K));
    }
  }
}
/// Eigenvalues of G_p, 1/cell^2, of a register of particles, of which `valid` are meant, from their modes. Returns
/// false where these do not serve.
template <class Body, class S, class V>
[[gnu::always_inline]] inline bool register_stiffness(const Body& body, std::size_t p, int valid, const Grid<S>& grid,
                                                      std::array<V, S::dimension>& b) {
  using Shape = typename Body::Shape;
  if constexpr (HasModes<Body>) {
    std::array<AxisModes<V, Shape::axis_nodes>, S::dimension> modes;
    const bool fit = body.shape.modes(body, p, grid, coordinates(body, p, grid), modes);
    axis_stiffness(modes, b);
    typename V::Integers beyond{};
    mark_beyond<Body>(modes, valid, grid, beyond);
    return fit && !any_of(beyond);
  } else if constexpr (HasDomainModes<Body>) {
    DomainModes<V> modes;
    const bool fit = body.shape.domain_modes(body, p, grid, modes);
    b = domain_stiffness(modes);
    return fit;
  } else {
    return false;
  }
}
/// Stiffness of the grid to a chunk of particles from their stencils.
template <class Body, class S, class V = typename Body::Lane>
[[gnu::noinline]] GridStiffness<V> stencil_stiffness(const Body& body, std::size_t first, int count,
                                                     const Grid<S>& grid) {
  GridStiffness<V> stiffness;
  for (std::size_t p = first; p < first + std::size_t(count); ++p)
    stiffness.raise(grid_stiffness<S>(make_stencil(body, p, grid), body.x(0)[p], grid.cell(), OwnShare{}));
  return stiffness;
}
/// The same from weights that are computed for it, where these serve.
template <class Body, class S, class V = typename Body::Lane>
GridStiffness<V> chunk_stiffness(const Body& body, std::size_t first, int count, const Grid<S>& grid) {
  using Scalar = typename V::Scalar;
  GridStiffness<V> stiffness;
  bool found = true;
  shapes::unrolled<chunk_size / V::size>([&](auto k) __attribute__((always_inline)) {
    constexpr int l = k * V::size;
    if (l >= count) return;
    std::array<V, S::dimension> b{};
    found = register_stiffness(body, first + l, count - l, grid, b) && found;
    const auto meant = first_lanes<V>(count - l);
    for (V& value : b) value = select(meant, value * V(grid.inverse_cell() * grid.inverse_cell()), V(0));
    V radius(1);
    if constexpr (S::hoop)
      radius = select(meant, V::load(body.x(0) + first + l), V(std::numeric_limits<Scalar>::max()));
    stiffness.raise(stiffness_of<S>(b, radius));
  });
  return found ? stiffness : stencil_stiffness(body, first, count, grid);
}
template <class T, int N>
GridStiffness<T> over_lanes(const GridStiffness<Lanes<T, N>>& b) {
  return {largest(b.most), largest(b.volume), total(b.unsound)};
}

/// 1/dt^2 of the largest stable step of a chunk of particles, by lane, from its limits and the stiffness of the grid to
/// it: Irons' bound, abs(grad v) dt < 0.1 and abs(v) dt < h / 2. NaN if there is none.
template <class V, class Scalar, class B>
[[gnu::always_inline]] inline V inverse_square_step(const StepLimits<Scalar>& l, const GridStiffness<B>& b,
                                                    Scalar inverse_cell) {
  const Scalar pace = 2 * l.speed * inverse_cell;
  return larger_or_nan(V(mpm::inverse_square_step(B(l.lambda), B(l.shear), b) + b.unsound),
                       V(larger_or_nan(100 * l.rate, pace * pace)));
}

/// The same from the weights of `count` particles from `first` on, where these `fit`. Infinite where their limits are
/// not known.
template <class Body, class S, int K, class V = typename Body::Lane, class Scalar = typename V::Scalar>
[[gnu::noinline]] V inverse_square_step(const StepLimits<Scalar>& limits, const Body& body, std::size_t first,
                                        int count, const Grid<S>& grid, const ChunkWeights<S, K>& weights, bool fit) {
  if (!limits.known) return V(std::numeric_limits<Scalar>::infinity());
  const Scalar cell = grid.cell();
  const V lambda(limits.lambda), shear(limits.shear), rate(100 * limits.rate * cell * cell), pace(2 * limits.speed);
  V most = max(rate, pace * pace), unsound = V(0) * (rate + pace);
  typename V::Integers beyond{};
  shapes::unrolled<chunk_size / V::size>([&](auto k) __attribute__((always_inline)) {
    constexpr int l = k * V::size;
    if (l >= count) return;
    std::array<AxisModes<V, K>, S::dimension> modes;
    weights.read(l, modes);
    std::array<V, S::dimension> b;
    axis_stiffness(modes, b);
    mark_beyond<Body>(modes, count - l, grid, beyond);
    V radius(1);
    if constexpr (S::hoop) radius = V::load(body.x(0) + first + l) * V(grid.inverse_cell());
    const V needed =
        select(first_lanes<V>(count - l), mpm::inverse_square_step(lambda, shear, stiffness_of<S>(b, radius)), V(0));
    most = max(most, needed), unsound += V(0) * needed;
  });
  if (!fit || any_of(beyond))
    return inverse_square_step<V>(limits, stencil_stiffness(body, first, count, grid), grid.inverse_cell());
  return V(grid.inverse_cell() * grid.inverse_cell()) * (most + unsound);
}

/// The largest of such, of which infinity stands for NaN.
template <class V>
auto largest_or_infinite(const V& a) {
  const auto q = largest(a);
  return q < std::numeric_limits<decltype(q)>::infinity() ? q : std::numeric_limits<decltype(q)>::infinity();
}

}  // namespace detail

/// The step that is safe for the chunks that looks_at(chunk), from the limits that the last step left for each, and the
/// stiffness of the grid, `stiffness(first, count)`; chunks of which they are not known are looked at plainly. Moduli,
/// rates and speeds are those at the end of the last step, the largest of a chunk.
template <class Body, class S, class F, class Stiffness, class Scalar = typename S::Scalar>
Scalar stable_step(const Body& body, const ChunkList& chunks, const Grid<S>& grid,
                   const std::vector<StepLimits<Scalar>>& limits, const F& looks_at, const Stiffness& stiffness) {
  struct Found {
    Scalar inverse_square, plain;
  };
  const Found none{std::numeric_limits<Scalar>::min(), std::numeric_limits<Scalar>::max()};
  const Found found = over_parts(
      std::int64_t(chunks.size()), chunks.worth_threads(), none,
      [&](std::int64_t begin, std::int64_t end) {
        Found here = none;
        for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
          const std::size_t first = chunks.first(k), c = first / chunk_size;
          if (!looks_at(c)) continue;
          const int size = chunks.count(k);
          const StepLimits<Scalar>& l = limits[c];
          if (l.known) {
            const auto b = detail::inverse_square_step<Scalar>(l, stiffness(first, size), grid.inverse_cell());
            here.inverse_square = larger_or_nan(here.inverse_square, b);
          } else {
            for (std::size_t p = first; p < first + std::size_t(size); ++p)
              here.plain = std::min(here.plain, stable_step(body, p, grid));
          }
        }
        here.inverse_square = detail::largest_or_infinite(here.inverse_square);
        return here;
      },
      [](const Found& a, const Found& b) {
        return Found{std::max(a.inverse_square, b.inverse_square), std::min(a.plain, b.plain)};
      });
  return std::min(found.plain, 1 / std::sqrt(found.inverse_square));
}

}  // namespace mpm
