// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/error.hpp>
#include <cstdint>
#include <limits>

namespace mpm::atlas {

/// Runs a solver to `end` and calls curve(x(), y()) so many times on the way. The last y is infinite where the run
/// stops, and no number where steps have become so short that 100 000 of them do not reach the end.
template <class SolverT, class X, class Y, class Curve>
void sampled_run(SolverT& solver, double end, int samples, const X& x, const Y& y, const Curve& curve) {
  constexpr std::int64_t most_steps = 100000;
  try {
    for (int k = 1; k <= samples; ++k) {
      while (solver.time < end * k / samples && solver.steps < most_steps) solver.step(end * k / samples - solver.time);
      if (solver.steps == most_steps) return curve(x(), std::numeric_limits<double>::quiet_NaN());
      curve(x(), y());
    }
  } catch (const Error&) {
    curve(x(), std::numeric_limits<double>::infinity());
  }
}

}  // namespace mpm::atlas
