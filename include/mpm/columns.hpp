// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace mpm {

/// Particles that are worked on together, a whole number of SIMD registers in any build.
inline constexpr int chunk_size = 16;

/// Structure of arrays: `Count` columns of equal length, each contiguous, one scalar a particle. Room for a chunk
/// follows each, so that a whole one may be read and written anywhere.
template <class T, int Count>
class Columns {
 public:
  std::size_t size() const { return size_; }

  /// Grows or shrinks every column; new entries are zero.
  void resize(std::size_t size) {
    for (int c = 0; c < Count; ++c) {
      data_[c].resize(size + chunk_size);
      if (size > size_)
        std::fill(data_[c].begin() + std::ptrdiff_t(size_), data_[c].begin() + std::ptrdiff_t(size), T(0));
    }
    size_ = size;
  }

  T* operator[](int column) { return data_[column].data(); }
  const T* operator[](int column) const { return data_[column].data(); }

  /// Reorders every column: entry i becomes the old entry order[i]. `scratch` keeps its memory between calls.
  void permute(std::span<const std::uint32_t> order, std::vector<T>& scratch) {
    if (size_ == 0) return;  // no room may have been made
    scratch.resize(size_ + chunk_size);
    for (int c = 0; c < Count; ++c) {
      for (std::size_t i = 0; i < size_; ++i) scratch[i] = data_[c][order[i]];
      std::copy_n(data_[c].begin() + std::ptrdiff_t(size_), chunk_size, scratch.begin() + std::ptrdiff_t(size_));
      data_[c].swap(scratch);
    }
  }

 private:
  std::vector<T> data_[Count > 0 ? Count : 1];
  std::size_t size_ = 0;
};

}  // namespace mpm
