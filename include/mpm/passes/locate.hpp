// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/corner_nodes.hpp>
#include <mpm/grid.hpp>
#include <mpm/stencil.hpp>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace mpm {

/// Where the particles of one body stand: ordered by block of the grid, the blocks by strip (a layer of blocks across
/// the last axis), those whose domains pass their strip's neighbourhood last.
struct ParticleOrder {
  std::vector<std::uint32_t> key;          ///< block of each particle; one past the last block for the wide ones
  std::vector<std::size_t> strip_begin;    ///< first particle of each strip, and of the tail at the end
  std::vector<std::uint32_t> permutation;  ///< work arrays of the counting sort
  std::vector<std::uint32_t> next;
  std::size_t tail_begin() const { return strip_begin.back(); }
};

/// w_Ip and grad w_Ip of particle p.
template <class Body, class S>
auto make_stencil(const Body& body, std::size_t p, const Grid<S>& grid) {
  Stencil<typename S::Scalar, S::dimension, Body::Shape::template max_nodes<S>> stencil;
  body.shape.stencil(body, p, grid, stencil);
  return stencil;
}

/// w_cp and grad w_cp of particle p on its own corners.
template <class Body, class S>
auto make_stencil(const Body& body, std::size_t p, const CornerNodes<S>&) {
  Stencil<typename S::Scalar, S::dimension, 4> stencil;
  body.shape.corner_stencil(p, stencil);
  return stencil;
}

namespace detail {

/// Block of particle p, or block_count if its stencil could touch nodes beyond those of its strip plus one row below
/// and two above: strips of one colour are a strip apart, so such a particle would break the colouring.
template <class Body, class S>
std::uint32_t block_of(const Body& body, std::size_t p, const Grid<S>& grid) {
  constexpr int edge = Grid<S>::block_edge;
  constexpr int last = S::dimension - 1;
  int block = 0;
  for (int d = 0; d < S::dimension; ++d)
    block += grid.cell_index(grid.coordinate(body.x(d)[p], d), d) / edge * grid.block_stride(d);
  const auto reach = body.shape.reach(body, p, grid);
  for (int d = 0; d < S::dimension; ++d) {
    const auto x = body.x(d)[p];
    const int row = grid.cell_index(grid.coordinate(x, d), d) / edge * edge;
    const int low = int(grid.coordinate(x - reach[d], d));
    const int high = int(grid.coordinate(x + reach[d], d)) + 1;
    if ((d == last && (low < row - 1 || high > row + edge + 1)) || low < row - edge || high > row + 2 * edge - 1)
      return std::uint32_t(grid.block_count());
  }
  return std::uint32_t(block);
}

inline void counting_sort(ParticleOrder& order, std::size_t keys) {
  const std::size_t n = order.key.size();
  order.next.assign(keys + 1, 0);
  for (std::uint32_t k : order.key) ++order.next[k + 1];
  std::partial_sum(order.next.begin(), order.next.end(), order.next.begin());
  order.permutation.resize(n);
  for (std::uint32_t p = 0; p < n; ++p) order.permutation[order.next[order.key[p]]++] = p;
  std::vector<std::uint32_t>& sorted = order.next;
  sorted.resize(std::max(n, keys + 1));
  for (std::size_t i = 0; i < n; ++i) sorted[i] = order.key[order.permutation[i]];
  std::copy_n(sorted.begin(), n, order.key.begin());
}

}  // namespace detail

/// Finds the block of every particle, reorders the body if one has left its place, and marks the blocks in use. Returns
/// whether it has reordered, by order.permutation.
template <class Body, class S>
bool locate(Body& body, Grid<S>& grid, ParticleOrder& order) {
  const std::size_t n = body.size();
  order.key.resize(n);
  const std::int64_t count = std::int64_t(n);
#pragma omp parallel for schedule(static)
  for (std::int64_t p = 0; p < count; ++p) order.key[p] = detail::block_of(body, std::size_t(p), grid);
  const bool reorder = !std::is_sorted(order.key.begin(), order.key.end());
  if (reorder) {
    detail::counting_sort(order, std::size_t(grid.block_count()) + 1);
    body.permute({order.permutation.data(), n});
  }
  const auto per_strip = std::uint32_t(grid.blocks_per_strip());
  order.strip_begin.resize(std::size_t(grid.strip_count()) + 1);
  auto from = order.key.begin();
  for (std::size_t s = 0; s < order.strip_begin.size(); ++s) {
    from = std::lower_bound(from, order.key.end(), std::uint32_t(s) * per_strip);
    order.strip_begin[s] = std::size_t(from - order.key.begin());
  }
  for (auto k = order.key.begin(), end = order.key.begin() + std::ptrdiff_t(order.tail_begin()); k != end;) {
    grid.activate_around(int(*k));
    k = std::upper_bound(k, end, *k);
  }
  for (std::size_t p = order.tail_begin(); p < n; ++p) {
    for (const auto& entry : make_stencil(body, p, grid)) grid.activate_node(entry.node);
  }
  return reorder;
}

/// Calls f(p) for every particle such that no two threads touch one node: even strips at once, then odd ones, then the
/// wide particles one by one. Within a strip the order is fixed, so sums have the same bits at any thread count.
template <class F>
void for_each_coloured(const ParticleOrder& order, const F& f) {
  const int strips = int(order.strip_begin.size()) - 1;
#pragma omp parallel
  for (int colour = 0; colour < 2; ++colour) {
#pragma omp for schedule(dynamic, 1)
    for (int s = colour; s < strips; s += 2)
      for (std::size_t p = order.strip_begin[s]; p < order.strip_begin[s + 1]; ++p) f(p);
  }
  for (std::size_t p = order.tail_begin(); p < order.key.size(); ++p) f(p);
}

/// Calls f(p) for every particle, in parallel; f may write to its own particle only.
template <class Body, class F>
void for_each_particle(const Body& body, const F& f) {
  const std::int64_t count = std::int64_t(body.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t p = 0; p < count; ++p) f(std::size_t(p));
}

}  // namespace mpm
