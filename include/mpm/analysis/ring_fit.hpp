// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/polar.hpp>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

// The read-out of particle stresses: never one particle (its stress carries the noise of the grid), but a
// volume-weighted least-squares fit over the particles around the place that is asked for.
namespace mpm::analysis {

/// Particles with their in-plane stresses, one entry a particle, all spans of one length.
struct StressSamples {
  std::span<const double> x{}, y{};          ///< positions, m
  std::span<const double> volume{};          ///< weights: volume, or area in the plane
  std::span<const double> xx{}, yy{}, xy{};  ///< stress, Pa, tension positive
  double centre_x{}, centre_y{};             ///< of the hole, m
};

/// f(theta) = mean + cos2 cos(2 theta).
struct Harmonic {
  double mean{}, cos2{};
  double at(double theta) const { return mean + cos2 * std::cos(2 * theta); }
};

/// Stress on the wall of a hole round the circle, Pa. Hoop stress at 0 and 90 degrees: `hoop.mean` +- `hoop.cos2`.
struct WallStress {
  Harmonic radial, hoop;
};

namespace detail {

/// Weighted least squares on N basis functions for three right-hand sides at once (rr, tt, rt).
template <std::size_t N>
class StressFit {
 public:
  void add(double weight, const std::array<double, N>& basis, const PolarStress& s) {
    ++count_;
    const std::array<double, 3> value{s.rr, s.tt, s.rt};
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j <= i; ++j) normal_[i][j] += weight * basis[i] * basis[j];
      for (std::size_t k = 0; k < 3; ++k) right_[i][k] += weight * basis[i] * value[k];
    }
  }

  /// Coefficients by Cholesky's factors; the basis is scaled to order one, so the normal equations are well behaved.
  /// Throws std::runtime_error, beginning with `where`, if the particles do not determine them.
  std::array<PolarStress, N> solve(const std::string& where) {
    for (std::size_t i = 0; i < N; ++i) {
      const double diagonal = normal_[i][i];
      for (std::size_t j = 0; j <= i; ++j) {
        for (std::size_t k = 0; k < j; ++k) normal_[i][j] -= normal_[i][k] * normal_[j][k];
        if (j < i) normal_[i][j] /= normal_[j][j];
      }
      if (count_ < N || !(normal_[i][i] > 1e-10 * diagonal))
        throw std::runtime_error(where + ": the " + std::to_string(count_) + " particles there do not determine " +
                                 std::to_string(N) + " coefficients; widen the window or refine the particles");
      normal_[i][i] = std::sqrt(normal_[i][i]);
    }
    for (std::size_t k = 0; k < 3; ++k) substitute(k);
    std::array<PolarStress, N> result{};
    for (std::size_t i = 0; i < N; ++i) result[i] = {right_[i][0], right_[i][1], right_[i][2]};
    return result;
  }

 private:
  void substitute(std::size_t k) {
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < i; ++j) right_[i][k] -= normal_[i][j] * right_[j][k];
      right_[i][k] /= normal_[i][i];
    }
    for (std::size_t i = N; i-- > 0;) {
      for (std::size_t j = i + 1; j < N; ++j) right_[i][k] -= normal_[j][i] * right_[j][k];
      right_[i][k] /= normal_[i][i];
    }
  }

  std::size_t count_ = 0;
  std::array<std::array<double, N>, N> normal_{};
  std::array<std::array<double, 3>, N> right_{};
};

/// Calls visit(r, theta, volume, polar stress) for each sample. Throws std::invalid_argument on unequal lengths.
template <class Visit>
void for_each_polar(const StressSamples& p, const Visit& visit) {
  const std::size_t n = p.x.size();
  for (const auto& column : {p.y, p.volume, p.xx, p.yy, p.xy})
    if (column.size() != n)
      throw std::invalid_argument("StressSamples: columns of " + std::to_string(n) + " and " +
                                  std::to_string(column.size()) + " particles; give all the same length");
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = p.x[i] - p.centre_x, dy = p.y[i] - p.centre_y, theta = std::atan2(dy, dx);
    visit(std::hypot(dx, dy), theta, p.volume[i], to_polar({p.xx[i], p.yy[i], p.xy[i]}, theta));
  }
}

}  // namespace detail

/// Stress on the ring of radius r (m), averaged over the angles that the particles cover: the value at dr = 0 of a fit
/// of {1, dr, dr^2} to the particles within `half_width` (m, about one cell) of the ring.
/// Throws std::invalid_argument on bad lengths and std::runtime_error if fewer than three radii are met.
inline PolarStress fit_ring(const StressSamples& samples, double r, double half_width) {
  detail::StressFit<3> fit;
  detail::for_each_polar(samples, [&](double rp, double, double volume, const PolarStress& s) {
    const double d = (rp - r) / half_width;
    if (std::abs(d) <= 1) fit.add(volume, {1, d, d * d}, s);
  });
  return fit.solve("fit_ring: r = " + std::to_string(r) + " m +- " + std::to_string(half_width) + " m")[0];
}

/// Stress on the wall of a hole of the given radius (m), from the particles within `window` (m) of it: the value at
/// y = 0 of a fit of {1, y, y^2} x {1, cos 2 theta}, y = (radius/r)^2 - 1, a basis that holds the Kirsch field exactly.
/// Throws std::invalid_argument on bad lengths or a window beyond half the radius, where the quadratic is no longer
/// local, and std::runtime_error if the particles do not determine the fit.
inline WallStress fit_wall(const StressSamples& samples, double radius, double window) {
  if (!(window > 0 && window <= 0.5 * radius))
    throw std::invalid_argument("fit_wall: window " + std::to_string(window) + " m; choose at most half the radius, " +
                                std::to_string(0.5 * radius) + " m");
  const double depth = 1 - std::pow(radius / (radius + window), 2);  // scales y to order one
  detail::StressFit<6> fit;
  detail::for_each_polar(samples, [&](double rp, double theta, double volume, const PolarStress& s) {
    if (rp > radius + window) return;
    const double y = (std::pow(radius / rp, 2) - 1) / depth, c = std::cos(2 * theta);
    fit.add(volume, {1, c, y, y * c, y * y, y * y * c}, s);
  });
  const auto coefficient =
      fit.solve("fit_wall: radius " + std::to_string(radius) + " m, window " + std::to_string(window) + " m");
  return {{coefficient[0].rr, coefficient[1].rr}, {coefficient[0].tt, coefficient[1].tt}};
}

}  // namespace mpm::analysis
