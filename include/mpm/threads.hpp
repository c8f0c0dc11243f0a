// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#ifdef _OPENMP
#include <omp.h>
#endif

// Work in parallel. Where it is not worth another thread it never reaches OpenMP, whose teams of one still call the
// system.
namespace mpm {

/// Whether a pass over so many particles, nodes or corners is worth more than one thread. One over fewer is done before
/// another thread has woken up.
constexpr bool worth_threads(std::size_t entries) {
  return entries > 2000;
}

namespace detail {
/// Kept a function of its own, as it is called from two places.
template <class Work, class... Index>
[[gnu::noinline]] auto worked(const Work& work, Index... index) {
  return work(index...);
}
}  // namespace detail

/// What work(begin, end) returns of the entries from 0 to `count`, in equal parts, one a thread, joined by join(a, b)
/// in any order, where `none` is what nothing returns.
template <class T, class Work, class Join>
T over_parts(std::int64_t count, [[maybe_unused]] bool worth, const T& none, const Work& work, const Join& join) {
#ifdef _OPENMP
  if (worth) {
    T all = none;
#pragma omp parallel
    {
      const std::int64_t parts = omp_get_num_threads(), k = omp_get_thread_num();
      const T own = detail::worked(work, count * k / parts, count * (k + 1) / parts);
#pragma omp critical(mpm_join)
      all = join(all, own);
    }
    return all;
  }
#endif
  return join(none, detail::worked(work, std::int64_t(0), count));
}
/// Calls f(k) for every k < `count`, in equal parts.
template <class F>
void for_each_part(std::int64_t count, bool worth, const F& f) {
  over_parts(
      count, worth, 0,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k) f(k);
        return 0;
      },
      [](int, int) { return 0; });
}
/// What work(s) returns of all strips s < `count`, joined as above: every colour-th of them at once, each by the thread
/// that gets free first, then those of the next colour.
template <class T, class Work, class Join>
T over_strips(int count, int colours, [[maybe_unused]] bool worth, const T& none, const Work& work, const Join& join) {
  T all = none;
#ifdef _OPENMP
  if (worth) {
#pragma omp parallel
    {
      T own = none;
      for (int colour = 0; colour < colours; ++colour) {
#pragma omp for schedule(dynamic, 1)
        for (int s = colour; s < count; s += colours) own = join(own, detail::worked(work, s));
      }
#pragma omp critical(mpm_join)
      all = join(all, own);
    }
    return all;
  }
#endif
  for (int colour = 0; colour < colours; ++colour)
    for (int s = colour; s < count; s += colours) all = join(all, detail::worked(work, s));
  return all;
}

}  // namespace mpm
