// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/columns.hpp>
#include <mpm/threads.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mpm {

/// The chunks of a list of particles, or of corners, that are worked on: all, unless some rest.
class ChunkList {
 public:
  ChunkList() = default;
  /// All chunks of `entries` particles.
  explicit ChunkList(std::size_t entries) { take_all(entries); }

  void take_all(std::size_t entries) {
    choose(entries, [](std::size_t, std::size_t) { return true; });
  }
  /// Those chunks of `entries` particles of which wanted(begin, end) is true.
  template <class F>
  void choose(std::size_t entries, const F& wanted) {
    entries_ = entries;
    first_.clear();
    first_.reserve((entries + chunk_size - 1) / chunk_size);
    for (std::size_t begin = 0; begin < entries; begin += chunk_size)
      if (wanted(begin, std::min(begin + chunk_size, entries))) first_.push_back(begin);
  }

  std::size_t entries() const { return entries_; }
  std::size_t size() const { return first_.size(); }
  bool worth_threads() const { return mpm::worth_threads(size() * chunk_size); }
  /// First entry of the k-th chunk of the list, and how many entries it has.
  std::size_t first(std::size_t k) const { return first_[k]; }
  int count(std::size_t k) const { return int(std::min<std::size_t>(chunk_size, entries_ - first_[k])); }

  /// Calls f(first, count) for every chunk of the list, in parallel.
  template <class F>
  void for_each(const F& f) const {
    for_each_part(std::int64_t(size()), worth_threads(),
                  [&](std::int64_t k) { f(first(std::size_t(k)), count(std::size_t(k))); });
  }
  /// Calls f(entry) for every entry of its chunks, in parallel; f may write to its own entry only.
  template <class F>
  void for_each_entry(const F& f) const {
    for_each([&](std::size_t begin, int n) {
      for (std::size_t p = begin; p < begin + std::size_t(n); ++p) f(p);
    });
  }
  /// The least of `most` and what f(first, count) returns of its chunks.
  template <class T, class F>
  T least(T most, const F& f) const {
    const auto lesser = [](T a, T b) { return std::min(a, b); };
    return over_parts(
        std::int64_t(size()), worth_threads(), most,
        [&](std::int64_t begin, std::int64_t end) {
          T least = most;
          for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k)
            least = lesser(least, f(first(k), count(k)));
          return least;
        },
        lesser);
  }

 private:
  std::size_t entries_ = 0;
  std::vector<std::size_t> first_;
};

}  // namespace mpm
