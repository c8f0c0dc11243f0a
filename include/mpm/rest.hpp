// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/grid.hpp>
#include <cstdint>
#include <vector>

namespace mpm {

/// Blocks of the grid where nothing moves yet, and which therefore cost nothing: their particles keep their state until
/// a node near them is faster than `speed`. Nodes that they share with particles that are worked on are held meanwhile,
/// for the sums there would lack their part. See Solver::let_rest.
template <Space S>
class Rest {
 public:
  using Scalar = typename S::Scalar;
  Scalar speed = 0;  ///< m/s

  /// Puts every block to sleep that `holds` particles and is not within two blocks of a block that `stirs`.
  void begin(Grid<S>& grid, const std::vector<char>& holds, const std::vector<char>& stirs) {
    grid.asleep = holds;
    for (int b = 0; b < grid.block_count(); ++b)
      if (stirs[std::size_t(b)])
        grid.for_each_block_around(b, 2, [&](int near) { grid.asleep[std::size_t(near)] = 0; });
    ++grid.rests;
  }
  /// Lists the held nodes, and the blocks in use beside sleeping ones, once the grid knows which blocks are in use.
  /// `resting(f)` calls f(node) for the nodes of all particles that rest.
  template <class F>
  void hold(const Grid<S>& grid, const F& resting) {
    if (seen_ == grid.rests) return;
    seen_ = grid.rests;
    held_.clear();
    rim_.clear();
    if (grid.asleep.empty()) return;
    is_held_.assign(grid.size(), 0);
    resting([&](int node) { is_held_[std::size_t(node)] = 1; });
    grid.for_each_active_block_in_order([&](int block) {
      bool beside = false;
      grid.for_each_block_around(block, 1, [&](int near) { beside = beside || grid.asleep[std::size_t(near)]; });
      if (!beside) return;
      rim_.push_back(block);
      grid.for_each_node(block, [&](int node) {
        if (is_held_[std::size_t(node)]) held_.push_back(node);
      });
    });
  }
  /// Stops the held nodes.
  void constrain(std::vector<Vector<S>>& field) const {
    for (int node : held_) field[std::size_t(node)].setZero();
  }
  /// Wakes the sleeping blocks within two blocks of a node that is faster than `speed`.
  void wake(Grid<S>& grid) const {
    bool changed = false;
    for (int block : rim_) {
      Scalar fastest = 0;
      grid.for_each_node(
          block, [&](int node) { fastest = larger_or_nan(fastest, grid.velocity[std::size_t(node)].squaredNorm()); });
      if (fastest <= speed * speed) continue;
      grid.for_each_block_around(block, 2, [&](int near) {
        changed = changed || grid.asleep[std::size_t(near)];
        grid.asleep[std::size_t(near)] = 0;
      });
    }
    if (!changed) return;
    ++grid.rests;
    if (std::find(grid.asleep.begin(), grid.asleep.end(), 1) == grid.asleep.end()) grid.asleep.clear();
  }

 private:
  std::vector<int> held_, rim_;
  std::vector<char> is_held_;
  std::uint32_t seen_ = 0;  ///< Grid::rests when the lists were made
};

}  // namespace mpm
