// SPDX-License-Identifier: MIT
#include "resting_step.hpp"
#include <cmath>
#include <limits>

namespace mpm::atlas {

double growth(Eigen::MatrixXd step, int doublings) {
  for (int k = 0; k < doublings; ++k) {
    const Eigen::MatrixXd square = step * step;
    if (!(square.norm() < 1e100)) return std::numeric_limits<double>::infinity();
    step = square;
  }
  return step.norm() / std::sqrt(double(step.rows()));
}

double true_limit(RestingStep& step) {
  const auto grows = [&](double dt) { return step.growth_rate(dt, 600) > 1.003; };
  double stable = step.certain(), unstable = 2 * stable;
  for (; !grows(unstable); unstable *= 2)
    if (stable = unstable; stable > 63 * step.certain()) return stable;
  while (unstable > 1.004 * stable) {
    const double dt = (stable + unstable) / 2;
    (grows(dt) ? unstable : stable) = dt;
  }
  return (stable + unstable) / 2;
}

}  // namespace mpm::atlas
