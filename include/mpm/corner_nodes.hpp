// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/chunk_list.hpp>
#include <mpm/grid.hpp>
#include <mpm/shapes/tensor_product.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace mpm {

/// The corners of a body's domains as nodes between its particles and the grid: a particle talks to its own corners,
/// and each corner, shared by neighbours, talks once to the grid as a point with hat functions. The sums are those of
/// the particle's direct stencil, in less than half the work.
template <Space S>
class CornerNodes : public NodalFields<S> {
 public:
  using Scalar = typename S::Scalar;
  using NodalFields<S>::mass;
  using NodalFields<S>::velocity;
  using NodalFields<S>::increment;
  using NodalFields<S>::strain_velocity;

  /// Two vectors of a corner in one word: momentum and force on the way to the grid, two fields of it on the way back.
  /// The passes in lanes work on these, the plain ones on the fields.
  struct alignas(4 * sizeof(Scalar)) Pair {
    std::array<Scalar, 4> value{};
  };
  std::vector<Pair> pair;

  /// The corners that are worked on, of those that there are, in chunks: those of the particles in `particles`.
  template <class Shape>
  void choose(const Shape& shape, const ChunkList& particles) {
    const std::size_t n = shape.corner.size();
    mass.resize(n, 0);
    increment.resize(n, Vector<S>::Zero());
    velocity.resize(n, Vector<S>::Zero());
    pair.resize(n);
    anchor_.resize(n);
    strip_begin_.clear();
    needed_.assign(n / chunk_size + 1, 0);
    for (std::size_t k = 0; k < particles.size(); ++k)
      for (std::size_t p = particles.first(k); p < particles.first(k) + std::size_t(particles.count(k)); ++p)
        for (const std::uint32_t c : shape.quad[p]) needed_[c / chunk_size] = 1;
    chunks_.choose(n, [&](std::size_t begin, std::size_t) { return needed_[begin / chunk_size] != 0; });
  }
  const ChunkList& chunks() const { return chunks_; }

  /// Finds the cell of every corner.
  void locate(const std::vector<std::array<double, 2>>& corner, const Grid<S>& grid) {
    stride_ = grid.stride(1);
    const auto look = [&](std::int64_t begin, std::int64_t end) {
      std::int64_t strays = 0;
      for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
        const std::size_t first = chunks_.first(k);
        for (std::size_t c = first; c < first + std::size_t(chunks_.count(k)); ++c) {
          const auto a = shapes::hat_axis(grid.coordinate(Scalar(corner[c][0]), 0), grid.cells(0));
          const auto b = shapes::hat_axis(grid.coordinate(Scalar(corner[c][1]), 1), grid.cells(1));
          const auto strip = std::uint32_t(b.first / Grid<S>::block_edge);
          strays += strip != anchor_[c].strip;
          anchor_[c] = {a.first + b.first * stride_, strip, a.w[1], b.w[1]};
        }
      }
      return strays;
    };
    const std::int64_t strays =
        (strip_begin_.empty() ? 1 : 0) +
        over_parts(std::int64_t(chunks_.size()), chunks_.worth_threads(), std::int64_t(0), look, std::plus<>());
    if (strays > 0) order_by_strip(std::size_t(grid.strip_count()));
  }

  /// The cell of a corner: its first node, and the corner's place between the nodes, 0 to 1.
  struct Anchor {
    int node = 0;
    std::uint32_t strip = 0;
    Scalar x = 0, y = 0;
  };
  const Anchor& anchor(std::size_t corner) const { return anchor_[corner]; }
  /// Nodes of the grid from one row to the next.
  int stride() const { return stride_; }

  /// Calls f(corners) for the list of corners in every strip, so that no two threads touch one node and in a fixed
  /// order at each: strips of one colour at once.
  template <class F>
  void for_each_strip(const F& f) const {
    const int strips = int(strip_begin_.size()) - 1;
    over_strips(
        strips, 2, chunks_.worth_threads(), 0,
        [&](int s) {
          f(std::span(order_).subspan(strip_begin_[s], strip_begin_[s + 1] - strip_begin_[s]));
          return 0;
        },
        [](int, int) { return 0; });
  }
  /// Calls f(corner, node, weight) for the four nodes around every corner, in the order of for_each_strip.
  template <class F>
  void scatter(const F& f) const {
    for_each_strip([&](std::span<const std::uint32_t> corners) {
      for (const std::size_t c : corners) around(c, [&](int node, Scalar w) { f(c, node, w); });
    });
  }
  /// Interpolates nodal fields of the grid to the corners: own = sum w nodal.
  void gather(const std::vector<Vector<S>>& nodal, std::vector<Vector<S>>& own) const {
    own.resize(anchor_.size(), Vector<S>::Zero());
    for_each([&](std::size_t c) {
      Vector<S> value = Vector<S>::Zero();
      around(c, [&](int node, Scalar w) { value += w * nodal[node]; });
      own[c] = value;
    });
  }
  /// Calls f(corner) for every corner, in parallel; f may write to its own corner only.
  template <class F>
  void for_each(const F& f) const {
    chunks_.for_each_entry(f);
  }

 private:
  template <class F>
  void around(std::size_t c, const F& f) const {
    const auto [node, strip, x, y] = anchor_[c];
    f(node, (1 - x) * (1 - y));
    f(node + 1, x * (1 - y));
    f(node + stride_, (1 - x) * y);
    f(node + stride_ + 1, x * y);
  }
  void order_by_strip(std::size_t strips) {
    strip_begin_.assign(strips + 1, 0);
    const auto for_each_in_order = [&](const auto& f) {
      for (std::size_t k = 0; k < chunks_.size(); ++k)
        for (std::size_t c = chunks_.first(k); c < chunks_.first(k) + std::size_t(chunks_.count(k)); ++c) f(c);
    };
    for_each_in_order([&](std::size_t c) { ++strip_begin_[anchor_[c].strip + 1]; });
    for (std::size_t s = 0; s < strips; ++s) strip_begin_[s + 1] += strip_begin_[s];
    next_ = strip_begin_;
    order_.resize(anchor_.size());
    for_each_in_order([&](std::size_t c) { order_[next_[anchor_[c].strip]++] = std::uint32_t(c); });
  }

  ChunkList chunks_;
  std::vector<char> needed_;
  std::vector<Anchor> anchor_;
  std::vector<std::uint32_t> order_;
  std::vector<std::size_t> strip_begin_, next_;
  int stride_ = 0;
};

}  // namespace mpm
