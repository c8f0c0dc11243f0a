// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body.hpp>
#include <mpm/concepts/space.hpp>
#include <mpm/error.hpp>
#include <mpm/threads.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace mpm {

/// What lives on nodes, of the grid or on the corners between particles and grid.
template <Space S>
struct NodalFields {
  std::vector<typename S::Scalar> mass;    ///< m_I, kg
  std::vector<Vector<S>> velocity;         ///< v_I, and v_I+ once the nodes are advanced, m/s
  std::vector<Vector<S>> increment;        ///< f_I, and v_I+ - v_I once the nodes are advanced
  std::vector<Vector<S>> strain_velocity;  ///< MUSL: the remapped velocity that strains the particles
};

/// The background grid: a box of cubic cells whose faces carry the boundary conditions.
///
/// Nodes are numbered x fastest. A stencil that would pass a face is folded onto it, so no node lies outside. Nodes are
/// worked on in blocks of 4 a side, of 64 on a line, and only blocks near particles are: an empty domain costs nothing.
template <Space S>
class Grid : public NodalFields<S> {
 public:
  using Scalar = typename S::Scalar;
  static constexpr int dimension = S::dimension;
  /// Nodes or cells along the edge of a block; on a line so many that its particles fill whole chunks.
  static constexpr int block_edge = dimension == 1 ? 64 : 4;
  static constexpr std::uint32_t nodes_per_block = dimension == 2 ? 16 : 64;

  using NodalFields<S>::mass;
  using NodalFields<S>::velocity;
  using NodalFields<S>::increment;

  /// Blocks that hold particles, none of which is worked on, since they rest; empty if there are none. See rest.hpp.
  std::vector<char> asleep;
  std::uint32_t rests = 0;  ///< counts the changes of it

  Grid() = default;
  /// A box from `origin` with `cells` cells of edge `cell` along each axis. Throws Error on a cell that is not positive
  /// or an empty box.
  Grid(const Vector<S>& box_origin, Scalar cell_edge, const std::array<int, dimension>& cell_counts)
      : origin_(box_origin), cell_(cell_edge), inverse_(1 / cell_edge), cells_(cell_counts) {
    if (!(cell_ > 0) || !std::isfinite(cell_))
      throw Error("grid: the cell must be positive, not " + std::to_string(cell_));
    std::size_t nodes = 1;
    int blocks = 1;
    for (int d = 0; d < dimension; ++d) {
      if (cells_[d] < 1) throw Error("grid: axis " + std::to_string(d) + " has no cell; give at least one");
      stride_[d] = int(nodes);
      block_stride_[d] = blocks;
      nodes *= std::size_t(cells_[d]) + 1;
      if (nodes > std::size_t(std::numeric_limits<int>::max()))
        throw Error("grid: more than 2^31 nodes; use a larger cell");
      blocks *= block_count(d);
    }
    mass.assign(nodes, 0);
    velocity.assign(nodes, Vector<S>::Zero());
    increment.assign(nodes, Vector<S>::Zero());
    is_active_.assign(std::size_t(blocks), 0);
    active_.reserve(std::size_t(blocks));
  }

  const Vector<S>& origin() const { return origin_; }
  Scalar cell() const { return cell_; }
  Scalar inverse_cell() const { return inverse_; }
  int cells(int d) const { return cells_[d]; }
  int stride(int d) const { return stride_[d]; }
  std::size_t size() const { return mass.size(); }
  Scalar upper(int d) const { return origin_[d] + cell_ * Scalar(cells_[d]); }

  /// Position in cells from the origin along axis d, held inside the box.
  Scalar coordinate(Scalar x, int d) const {
    return std::clamp((x - origin_[d]) * inverse_, Scalar(0), Scalar(cells_[d]));
  }
  /// Index along axis d of the cell that holds `coordinate`.
  int cell_index(Scalar coordinate, int d) const { return std::min(int(coordinate), cells_[d] - 1); }
  Vector<S> position(int node) const {
    Vector<S> x;
    for (int d = dimension - 1; d >= 0; --d) {
      x[d] = origin_[d] + cell_ * Scalar(node / stride_[d]);
      node %= stride_[d];
    }
    return x;
  }

  int block_count(int d) const { return cells_[d] / block_edge + 1; }
  int block_count() const { return int(is_active_.size()); }
  /// Blocks in one strip: a layer of blocks across the last axis.
  int blocks_per_strip() const { return block_stride_[dimension - 1]; }
  int strip_count() const { return block_count(dimension - 1); }
  int block_stride(int d) const { return block_stride_[d]; }

  void deactivate_all() {
    for (int b : active_) is_active_[b] = 0;
    active_.clear();
  }
  /// Marks a block and its neighbours: what particles in it can reach.
  void activate_around(int block) {
    for_each_block_around(block, 1, [&](int b) { activate(b); });
  }
  /// Calls f(block) for a block and all within `reach` blocks of it.
  template <class F>
  void for_each_block_around(int block, int reach, const F& f) const {
    std::array<int, dimension> low, high;
    for (int d = dimension - 1; d >= 0; --d) {
      const int i = block / block_stride_[d];
      block %= block_stride_[d];
      low[d] = std::max(i - reach, 0), high[d] = std::min(i + reach, block_count(d) - 1);
    }
    for_each_index(low, high, [&](const auto& i) { f(block_index(i)); });
  }
  /// Marks the block of one node.
  void activate_node(int node) { activate(block_of(node)); }
  int block_of(int node) const {
    int block = 0;
    for (int d = dimension - 1; d >= 0; --d) {
      block += node / stride_[d] / block_edge * block_stride_[d];
      node %= stride_[d];
    }
    return block;
  }
  /// The block that holds x, which must be inside the box.
  int block_at(const Vector<S>& x) const {
    int block = 0;
    for (int d = 0; d < dimension; ++d) block += cell_index(coordinate(x[d], d), d) / block_edge * block_stride_[d];
    return block;
  }
  /// Fixes the order in which active blocks are worked on.
  void sort_active() { std::sort(active_.begin(), active_.end()); }

  /// Calls f(node) for every node of every active block, blocks in parallel.
  template <class F>
  void for_each_active(const F& f) const {
    for_each_active_block([&](int block) { for_each_node(block, f); });
  }
  /// Calls f(block) for every active block, in parallel.
  template <class F>
  void for_each_active_block(const F& f) const {
    for_each_part(std::int64_t(active_.size()), worth_threads(active_.size() * nodes_per_block),
                  [&](std::int64_t a) { f(active_[std::size_t(a)]); });
  }
  /// Calls f(block) for every active block, one by one.
  template <class F>
  void for_each_active_block_in_order(const F& f) const {
    for (int b : active_) f(b);
  }
  bool active(int block) const { return is_active_[block] != 0; }
  /// Calls f(node) for every node of a block.
  template <class F>
  void for_each_node(int block, const F& f) const {
    std::array<int, dimension> low, high;
    for (int d = dimension - 1; d >= 0; --d) {
      low[d] = block / block_stride_[d] * block_edge;
      high[d] = std::min(low[d] + block_edge - 1, cells_[d]);
      block %= block_stride_[d];
    }
    for_each_index(low, high, [&](const auto& i) { f(node_index(i)); });
  }
  /// Sum over active nodes of f(node), added in a fixed order: the same bits at any thread count.
  template <class F>
  double sum_active(const F& f) const {
    partial_.resize(active_.size());
    for_each_part(std::int64_t(active_.size()), worth_threads(active_.size() * nodes_per_block), [&](std::int64_t a) {
      double sum = 0;
      for_each_node(active_[std::size_t(a)], [&](int node) { sum += double(f(node)); });
      partial_[std::size_t(a)] = sum;
    });
    double total = 0;
    for (double p : partial_) total += p;
    return total;
  }
  /// Calls f(node) for every node of the face `side` (0 lower, 1 upper) of axis d, in a fixed order.
  template <class F>
  void for_each_on_face(int d, int side, const F& f) const {
    std::array<int, dimension> low{}, high = cells_;
    low[d] = high[d] = side == 0 ? 0 : cells_[d];
    for_each_index(low, high, [&](const auto& i) { f(node_index(i), i); });
  }

  int node_index(const std::array<int, dimension>& i) const {
    int node = 0;
    for (int d = 0; d < dimension; ++d) node += i[d] * stride_[d];
    return node;
  }
  int block_index(const std::array<int, dimension>& i) const {
    int block = 0;
    for (int d = 0; d < dimension; ++d) block += i[d] * block_stride_[d];
    return block;
  }

 private:
  void activate(int block) {
    if (is_active_[block]) return;
    is_active_[block] = 1;
    active_.push_back(block);
  }
  template <class F>
  static void for_each_index(const std::array<int, dimension>& low, const std::array<int, dimension>& high,
                             const F& f) {
    std::array<int, dimension> i = low;
    const auto inner = [&] {
      for (i[0] = low[0]; i[0] <= high[0]; ++i[0]) f(i);
    };
    if constexpr (dimension == 1) {
      inner();
    } else if constexpr (dimension == 2) {
      for (i[1] = low[1]; i[1] <= high[1]; ++i[1]) inner();
    } else {
      for (i[2] = low[2]; i[2] <= high[2]; ++i[2])
        for (i[1] = low[1]; i[1] <= high[1]; ++i[1]) inner();
    }
  }

  Vector<S> origin_ = Vector<S>::Zero();
  Scalar cell_ = 1, inverse_ = 1;
  std::array<int, dimension> cells_{}, stride_{}, block_stride_{};
  std::vector<char> is_active_;
  std::vector<int> active_;
  mutable std::vector<double> partial_;
};

}  // namespace mpm
