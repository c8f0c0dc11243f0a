// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/blast_cavity.hpp>

namespace mpm::analysis {

/// Blair's pulse through a wall-pressure history (s, Pa; from rest on): the peak's height and time are the history's
/// own, which leaves n, found by least squares with gamma = n/t_peak. Throws std::invalid_argument if the spans differ
/// in length or no pressure is positive after t = 0.
inline BlairLoad fit_blair(std::span<const double> time, std::span<const double> pressure) {
  if (time.size() != pressure.size())
    throw std::invalid_argument("fit_blair: " + std::to_string(time.size()) + " times for " +
                                std::to_string(pressure.size()) + " pressures");
  std::size_t top = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    if (time[i] > 0 && (!(time[top] > 0) || pressure[i] > pressure[top])) top = i;
  if (time.empty() || !(time[top] > 0 && pressure[top] > 0))
    throw std::invalid_argument("fit_blair: no pressure is positive after t = 0");
  const auto load = [&](double log_n) {
    return BlairLoad{.peak = pressure[top], .n = std::exp(log_n), .gamma = std::exp(log_n) / time[top]};
  };
  const auto error = [&](double log_n) {
    double sum = 0;
    for (std::size_t i = 0; i < time.size(); ++i)
      sum +=
          std::pow(load(log_n).pressure(time[i]) - pressure[i], 2) * (i + 1 < time.size() ? time[i + 1] - time[i] : 0);
    return sum;
  };
  double low = std::log(1e-3), high = std::log(50.);
  while (high - low > 1e-9) {
    constexpr double golden = 1 / std::numbers::phi;
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    if (error(left) < error(right))
      high = right;
    else
      low = left;
  }
  return load((low + high) / 2);
}

}  // namespace mpm::analysis
