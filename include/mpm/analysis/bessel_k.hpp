// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <complex>
#include <numbers>

namespace mpm::analysis {

/// Modified Bessel functions of the second kind times exp(z): finite where K itself would underflow.
struct ScaledBesselK {
  std::complex<double> k0, k1;
};

namespace detail {

/// Ascending series (Abramowitz & Stegun 9.6.10 to 9.6.13). Loses |I/K| to cancellation: good to |z| = 4.
inline ScaledBesselK bessel_k_series(std::complex<double> z) {
  const std::complex<double> q = 0.25 * z * z, log_half = std::log(0.5 * z);
  std::complex<double> term = 1, i0 = 0, i1 = 0, s0 = 0, s1 = 0;  // term = q^k/(k!)^2
  double psi = -std::numbers::egamma;                             // digamma(k + 1)
  for (int k = 0; k < 40 && std::norm(term) > 1e-40 * std::norm(i0); ++k) {
    const double next = 1.0 / (k + 1);
    i0 += term, s0 += psi * term;
    i1 += next * term, s1 += (psi + 0.5 * next) * next * term;
    term *= q * (next * next), psi += next;
  }
  const std::complex<double> e = std::exp(z);
  return {e * (s0 - log_half * i0), e * (1.0 / z + 0.5 * z * (log_half * i1 - s1))};
}

/// Trapezoidal rule on the whole line for the even integrands of (DLMF 10.32.8, with z (t - 1) = w^2)
///   K0 e^z = 2 int_0^inf exp(-w^2)/sqrt(w^2 + 2z) dw,   K1 e^z = (2/z) int_0^inf exp(-w^2) w^2 sqrt(w^2 + 2z) dw.
/// The branch points lie Re sqrt(2z) >= sqrt|z| off the line, so the error is exp(-2 pi sqrt|z|/step): 4e-17 at 4.
inline ScaledBesselK bessel_k_quadrature(std::complex<double> z) {
  constexpr double step = 1.0 / 3, end = 6.2;
  const std::complex<double> z2 = 2.0 * z;
  std::complex<double> k0 = 0.5 / std::sqrt(z2), k1 = 0;
  for (int i = 1; i * step < end; ++i) {
    const double w2 = (i * step) * (i * step), gauss = std::exp(-w2);
    const std::complex<double> root = std::sqrt(w2 + z2);
    k0 += gauss / std::norm(root) * std::conj(root);
    k1 += gauss * w2 * root;
  }
  return {2 * step * k0, 2 * step / z * k1};
}

}  // namespace detail

/// exp(z) K0(z) and exp(z) K1(z) in the right half plane, Re z >= 0 and z != 0, to about 1e-13 relative.
inline ScaledBesselK scaled_bessel_k(std::complex<double> z) {
  return std::norm(z) < 16 ? detail::bessel_k_series(z) : detail::bessel_k_quadrature(z);
}

}  // namespace mpm::analysis
