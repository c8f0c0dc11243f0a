// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace mpm {

/// Structure of arrays: `Count` columns of equal length, each contiguous, one scalar a particle.
template <class T, int Count>
class Columns {
 public:
  std::size_t size() const { return size_; }

  /// Grows or shrinks every column; new entries are zero.
  void resize(std::size_t size) {
    for (auto& column : data_) column.resize(size);
    size_ = size;
  }

  T* operator[](int column) { return data_[column].data(); }
  const T* operator[](int column) const { return data_[column].data(); }

  /// Reorders every column: entry i becomes the old entry order[i]. `scratch` keeps its memory between calls.
  void permute(std::span<const std::uint32_t> order, std::vector<T>& scratch) {
    scratch.resize(size_);
    for (auto& column : data_) {
      for (std::size_t i = 0; i < size_; ++i) scratch[i] = column[order[i]];
      column.swap(scratch);
    }
  }

 private:
  std::vector<T> data_[Count > 0 ? Count : 1];
  std::size_t size_ = 0;
};

}  // namespace mpm
