// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <ctime>

// Problems with an exact solution, set up once for the closed-form tests and for the chart of accuracy against cost.
namespace mpm::problems {

/// What one run of a problem gave and took.
struct Outcome {
  double error = 0;            ///< relative to the exact solution, in the norm the problem names
  std::int64_t particles = 0;  ///< of all bodies
  std::int64_t steps = 0;      ///< taken
  double seconds = 0;          ///< processor time of the stepping loop, s
  std::size_t bytes = 0;       ///< a particle of the (first) body holds
};

/// Processor time of this process, s.
inline double processor_seconds() {
  return double(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace mpm::problems
