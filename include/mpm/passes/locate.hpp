// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/corner_nodes.hpp>
#include <mpm/grid.hpp>
#include <mpm/shapes/modes.hpp>
#include <mpm/stencil.hpp>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace mpm {

/// Where the particles of one body stand: ordered by strip (a layer of blocks across the last axis of the grid), within
/// it by block and anchor node, so that neighbours share their stencils; those whose stencils pass their strip's
/// neighbourhood last.
///
/// The order is renewed when it must be, not each step: a particle keeps its place while its stencil lies within two
/// rows of its strip, since strips of one colour are a strip apart.
struct ParticleOrder {
  std::vector<std::uint32_t> key;          ///< block and anchor within it; one past the last for the wide ones
  std::vector<std::size_t> strip_begin;    ///< first particle of each strip, and of the tail at the end
  std::vector<std::uint32_t> permutation;  ///< work arrays of the counting sort
  std::vector<std::uint32_t> next;
  ChunkList chunks;                  ///< those that are worked on: all, unless their blocks rest
  std::vector<std::size_t> run;      ///< begin and end of what is worked on in each strip, piece by piece
  std::vector<std::size_t> run_end;  ///< behind the last piece of each strip, in `run`
  std::uint32_t rests_seen = 0;      ///< Grid::rests when the chunks were chosen

  std::size_t tail_begin() const { return strip_begin.back(); }
  /// Calls f(begin, end) for every piece of a strip that is worked on.
  template <class F>
  void for_each_run(std::size_t strip, const F& f) const {
    for (std::size_t k = strip == 0 ? 0 : run_end[strip - 1]; k < run_end[strip]; k += 2) f(run[k], run[k + 1]);
  }
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

/// A stencil of a fixed number of nodes along each axis.
template <class Shape>
concept has_fixed_stencil = Shape::domain_motion == DomainMotion::rigid&& requires {
  Shape::axis_nodes;
};

/// Cells by which domains that change may drift before they are looked at again.
template <class Shape>
inline constexpr double slack = Shape::domain_motion == DomainMotion::rigid ? 0 : 0.25;

/// Where one particle stands in the grid.
struct Place {
  std::uint32_t key = 0;  ///< block, and anchor within it: the nearest node for stencils of three nodes, else the lower
  int low = 0, high = 0;  ///< rows of its stencil along the last axis
  bool near = true;       ///< its stencil lies in its own block and the ones beside it

  /// Whether it may be worked on with strip s: strips of one colour then share no row.
  template <class S>
  bool fits(int s) const {
    return near && low >= s * Grid<S>::block_edge - 2 && high <= (s + 1) * Grid<S>::block_edge + 1;
  }
};

template <class Body, class S>
Place place_of(const Body& body, std::size_t p, const Grid<S>& grid) {
  using Scalar = typename S::Scalar;
  using Shape = typename Body::Shape;
  constexpr int edge = Grid<S>::block_edge;
  int block = 0, inner = 0;
  Place place;
  std::array<Scalar, S::dimension> reach{};
  if constexpr (!has_fixed_stencil<Shape>) {
    reach = body.shape.reach(body, p, grid);
    for (Scalar& r : reach) r += Scalar(slack<Shape>) * grid.cell();
  }
  for (int d = S::dimension - 1; d >= 0; --d) {
    const Scalar x = body.x(d)[p], xi = grid.coordinate(x, d);
    int anchor = grid.cell_index(xi, d), low, high;
    if constexpr (requires { requires Shape::axis_nodes == 3; }) anchor = int(xi + Scalar(0.5));
    if constexpr (has_fixed_stencil<Shape>) {
      low = anchor - shapes::nodes_before<Shape::axis_nodes>, high = low + Shape::axis_nodes - 1;
    } else {
      low = int(grid.coordinate(x - reach[d], d)), high = int(grid.coordinate(x + reach[d], d)) + 1;
    }
    if constexpr (requires { requires Shape::axis_nodes == 3; }) {  // nodes without weight are added to, too
      const Scalar drift = Scalar(slack<Shape> + 0.5);
      low = std::min(low, int(xi + Scalar(1) - drift) - 1), high = std::max(high, int(xi + drift) + 1);
    }
    if (d == S::dimension - 1) place.low = low, place.high = high;
    block += anchor / edge * grid.block_stride(d);
    inner = inner * edge + anchor % edge;
    const int row = anchor / edge * edge;
    place.near = place.near && low >= row - edge && high <= row + 2 * edge - 1;
  }
  if (Shape::domain_motion == DomainMotion::corners) inner = 0;  // its own mesh's order shares more than the grid's
  place.key = std::uint32_t(block) * grid.nodes_per_block + std::uint32_t(inner);
  return place;
}

/// place_of for a register of particles at once: the keys from begin to end. Returns how many do not fit strip `strip`.
template <class Body, class S>
std::int64_t find_fixed_places(const Body& body, const Grid<S>& grid, std::uint32_t* key, std::size_t begin,
                               std::size_t end, int strip) {
  using V = typename Body::Lane;
  using Integers = typename V::Integers;
  constexpr int K = Body::Shape::axis_nodes, edge = Grid<S>::block_edge, last = S::dimension - 1;
  constexpr int bits = std::countr_zero(unsigned(edge));
  static_assert(edge == 1 << bits);
  const int lowest = strip * edge - 2 + shapes::nodes_before<K>;
  const int highest = (strip + 1) * edge + 1 - (K - 1 - shapes::nodes_before<K>);
  std::int64_t lost = 0;
  for (std::size_t p = begin; p < end; p += V::size) {
    const int valid = int(std::min<std::size_t>(V::size, end - p));
    Integers block{}, inner{}, row{};
    for (int d = last; d >= 0; --d) {
      const V xi =
          max(V(0), min((V::load(body.x(d) + p) - V(grid.origin()[d])) * V(grid.inverse_cell()), V(grid.cells(d))));
      Integers anchor = K == 3 ? truncated(xi + V(0.5)) : shapes::cell_of(xi, grid.cells(d));
      if (d == last) row = anchor;
      block += (anchor >> bits) * grid.block_stride(d);
      inner = inner * edge + (anchor & (edge - 1));
    }
    const Integers found = block * int(grid.nodes_per_block) + inner;
    for (int k = 0; k < valid; ++k) {
      key[p + std::size_t(k)] = std::uint32_t(found[k]);
      lost += row[k] < lowest || row[k] > highest;
    }
  }
  return lost;
}

/// Keys of all particles at their present places. Returns whether they must be ordered anew: one has left its strip's
/// neighbourhood, or so many their cell that stencils are hardly shared any more.
template <class Body, class S>
bool find_places(const Body& body, const Grid<S>& grid, ParticleOrder& order) {
  struct Found {
    std::int64_t lost = 0, out_of_order = 0;
  };
  const auto found = over_strips(
      int(order.strip_begin.size()) - 1, 1, order.chunks.worth_threads(), Found{},
      [&](int s) {
        Found here;
        order.for_each_run(std::size_t(s), [&](std::size_t begin, std::size_t end) {
          if constexpr (has_fixed_stencil<typename Body::Shape>) {
            here.lost += find_fixed_places(body, grid, order.key.data(), begin, end, s);
          } else {
            for (std::size_t p = begin; p < end; ++p) {
              const Place place = place_of(body, p, grid);
              here.lost += !place.template fits<S>(s);
              order.key[p] = place.key;
            }
          }
          for (std::size_t p = begin + 1; p < end; ++p) here.out_of_order += order.key[p] < order.key[p - 1];
        });
        return here;
      },
      [](const Found& a, const Found& b) {
        return Found{a.lost + b.lost, a.out_of_order + b.out_of_order};
      });
  return found.lost > 0 || found.out_of_order > std::int64_t(body.size() / 16);
}

/// Stable counting sort of the particles by key.
template <class Body, class S>
void sort_particles(Body& body, const Grid<S>& grid, ParticleOrder& order) {
  const std::size_t n = body.size();
  const std::uint32_t wide = std::uint32_t(grid.block_count()) * grid.nodes_per_block;
  order.key.resize(n);
  for_each_part(std::int64_t(n), worth_threads(n), [&](std::int64_t p) {
    const Place place = place_of(body, std::size_t(p), grid);
    const int strip = int(place.key / grid.nodes_per_block) / grid.blocks_per_strip();
    order.key[std::size_t(p)] = place.template fits<S>(strip) ? place.key : wide;
  });
  order.next.assign(std::size_t(wide) + 2, 0);
  for (std::uint32_t k : order.key) ++order.next[k + 1];
  std::partial_sum(order.next.begin(), order.next.end(), order.next.begin());
  for (std::size_t s = 0; s < order.strip_begin.size(); ++s)
    order.strip_begin[s] =
        order.next[std::min(std::uint32_t(s) * std::uint32_t(grid.blocks_per_strip()) * grid.nodes_per_block, wide)];
  order.permutation.resize(n);
  for (std::uint32_t p = 0; p < n; ++p) order.permutation[order.next[order.key[p]]++] = p;
  order.next.resize(std::max(n, order.next.size()));
  for (std::size_t i = 0; i < n; ++i) order.next[i] = order.key[order.permutation[i]];
  std::copy_n(order.next.begin(), n, order.key.begin());
  body.permute({order.permutation.data(), n});
}

/// Lists the chunks that have a particle in a block that is awake, and the pieces of strips that they make.
template <class S>
void choose_chunks(const Grid<S>& grid, ParticleOrder& order) {
  order.chunks.choose(order.key.size(), [&](std::size_t begin, std::size_t end) {
    bool awake = end > order.tail_begin() || grid.asleep.empty();
    for (std::size_t p = begin; p < end && !awake; ++p) awake = !grid.asleep[order.key[p] / grid.nodes_per_block];
    return awake;
  });
  order.run.clear();
  order.run.reserve(2 * (order.chunks.size() + order.strip_begin.size()));
  order.run_end.clear();
  std::size_t k = 0;
  for (std::size_t s = 0; s + 1 < order.strip_begin.size(); ++s) {
    const std::size_t strip_end = order.strip_begin[s + 1];
    std::size_t end = order.strip_begin[s];
    while (k < order.chunks.size() && order.chunks.first(k) < strip_end) {
      const std::size_t chunk_end = order.chunks.first(k) + std::size_t(order.chunks.count(k));
      const std::size_t first = std::max(order.chunks.first(k), order.strip_begin[s]),
                        last = std::min(chunk_end, strip_end);
      if (first == end && order.run.size() > (s == 0 ? 0 : order.run_end[s - 1])) {
        order.run.back() = last;
      } else if (first < last) {
        order.run.push_back(first), order.run.push_back(last);
      }
      end = last;
      if (chunk_end > strip_end) break;  // goes on in the next strip
      ++k;
    }
    order.run_end.push_back(order.run.size());
  }
  order.rests_seen = grid.rests;
}

}  // namespace detail

/// What `locate` has changed.
enum class Relocated { nothing, chunks, order };

/// Finds the place of every particle that is worked on, unless all are `settled`, reorders the body where needed, by
/// order.permutation, and marks the blocks in use.
template <class Body, class S>
Relocated locate(Body& body, Grid<S>& grid, ParticleOrder& order, bool settled = false) {
  const std::size_t n = body.size();
  const bool known = order.key.size() == n && order.strip_begin.size() == std::size_t(grid.strip_count()) + 1;
  if (!known) order.strip_begin.assign(std::size_t(grid.strip_count()) + 1, 0);
  const bool sort = !known || (!settled && detail::find_places(body, grid, order));
  if (sort) detail::sort_particles(body, grid, order);
  const bool choose = sort || order.rests_seen != grid.rests;
  if (choose) detail::choose_chunks(grid, order);
  std::uint32_t last = std::uint32_t(-1);
  for (std::size_t k = 0; k < order.run.size(); k += 2)
    for (std::size_t p = order.run[k]; p < order.run[k + 1]; ++p) {
      const std::uint32_t block = order.key[p] / grid.nodes_per_block;
      if (block != last) grid.activate_around(int(block));
      last = block;
    }
  for (std::size_t p = order.tail_begin(); p < n; ++p) {
    for (const auto& entry : make_stencil(body, p, grid)) grid.activate_node(entry.node);
  }
  return sort ? Relocated::order : choose ? Relocated::chunks : Relocated::nothing;
}

/// Calls f(begin, end) for the particles of every strip that are worked on, such that no two threads touch one node:
/// even strips at once, then odd ones. The order is fixed, so sums have the same bits at any thread count. Returns the
/// least of what f returns. f(begin, end, most) may also raise `most`, a number or lanes. With three colours particles
/// may touch a row more than where they stand.
template <int Colours = 2, class F, class V>
std::size_t for_each_strip(const ParticleOrder& order, const F& f, V& most) {
  struct Found {
    std::size_t least;
    V most;
  };
  const Found found = over_strips(
      int(order.strip_begin.size()) - 1, Colours, order.chunks.worth_threads(),
      Found{std::numeric_limits<std::size_t>::max(), most},
      [&](int s) {
        Found here{std::numeric_limits<std::size_t>::max(), most};
        order.for_each_run(std::size_t(s), [&](std::size_t begin, std::size_t end) {
          here.least = std::min(here.least, f(begin, end, here.most));
        });
        return here;
      },
      [](const Found& a, const Found& b) {
        return Found{std::min(a.least, b.least), larger_or_nan(a.most, b.most)};
      });
  most = found.most;
  return found.least;
}
template <int Colours = 2, class F>
std::size_t for_each_strip(const ParticleOrder& order, const F& f) {
  double none = 0;
  return for_each_strip<Colours>(
      order, [&](std::size_t begin, std::size_t end, double&) { return f(begin, end); }, none);
}

/// Calls f(p) for every particle that is worked on, strip by strip, then for the wide particles one by one.
template <int Colours = 2, class F>
void for_each_coloured(const ParticleOrder& order, const F& f) {
  for_each_strip<Colours>(order, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) f(p);
    return end;
  });
  for (std::size_t p = order.tail_begin(); p < order.key.size(); ++p) f(p);
}

}  // namespace mpm
