// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace mpm::analysis {

/// Inverse Laplace transform at one time t > 0 (Durbin 1974), of N functions at once.
///
/// Durbin's Fourier series has abscissae alpha + i k pi/T. With T = 2 t its cosines and sines are 0 and +-1, so it
/// alternates and Euler's transformation sums it; alpha T = 20 puts the aliasing at exp(-40) and amplifies round-off
/// by exp(10). Good to about 1e-11 of the function's scale where it is smooth for t > 0.
///
/// `transform(m)` returns std::array<std::complex<double>, N>, analytic for Re m > 0. `frequency` (rad/s) bounds the
/// imaginary parts of its dominant singularities: the summation by differences starts beyond them.
template <std::size_t N, class Transform>
std::array<double, N> invert_durbin(const Transform& transform, double t, double frequency) {
  constexpr int averaged = 16;
  const double spacing = std::numbers::pi / (2 * t), alpha = 10 / t;
  const int direct = 16 + static_cast<int>(1.5 * frequency / (2 * spacing));

  std::array<std::array<double, averaged + 1>, N> partial{};
  std::array<double, N> sum{};
  for (int j = 0; j <= direct + averaged; ++j) {
    const auto even = transform(std::complex<double>(alpha, 2 * j * spacing));
    const auto odd = transform(std::complex<double>(alpha, (2 * j + 1) * spacing));
    for (std::size_t i = 0; i < N; ++i) {
      const double term = (j == 0 ? 0.5 : 1.0) * even[i].real() - odd[i].imag();
      sum[i] += j % 2 == 0 ? term : -term;
      if (j >= direct) partial[i][static_cast<std::size_t>(j - direct)] = sum[i];
    }
  }

  std::array<double, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t level = averaged; level > 0; --level)
      for (std::size_t j = 0; j < level; ++j) partial[i][j] = 0.5 * (partial[i][j] + partial[i][j + 1]);
    result[i] = std::exp(alpha * t) / (2 * t) * partial[i][0];
  }
  return result;
}

}  // namespace mpm::analysis
