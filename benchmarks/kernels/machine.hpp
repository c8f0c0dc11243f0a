// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/lanes.hpp>
#include <benchmark/benchmark.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <vector>

// What one core of this machine can do, measured before anything is timed against it.
namespace kernels {

/// Seconds of the fastest of `repeats` calls.
template <class F>
double fastest(int repeats, const F& f) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    f();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

/// Multiply-adds on registers, enough of them at once to hide their latency: operations a second, a multiply-add
/// counted as two.
inline double peak_flops() {
  using V = mpm::LanesOf<double>;
  constexpr int chains = 10, rounds = 1000000;
  std::array<V, chains> a;
  for (int i = 0; i < chains; ++i) a[std::size_t(i)] = V(1. + i);
  V factor(.999), term(1e-3);
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(term);
  const double seconds = fastest(5, [&] {
    for (int k = 0; k < rounds; ++k)
      for (V& x : a) x = x * factor + term;
    benchmark::DoNotOptimize(a);
  });
  return 2. * chains * rounds * V::size / seconds;
}

/// a = b + s c on arrays far larger than the caches: bytes a second, three moved an entry.
inline double triad_bytes() {
  constexpr std::size_t n = 8 << 20;
  std::vector<double> a(n, 0), b(n, 1), c(n, 2);
  const double seconds = fastest(5, [&] {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + .5 * c[i];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  });
  return 3. * sizeof(double) * double(n) / seconds;
}

}  // namespace kernels
