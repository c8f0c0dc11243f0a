// SPDX-License-Identifier: MIT
#include "linear_step.hpp"
#include <cmath>
#include <limits>
#include <random>

namespace mpm::atlas {

double growth(Eigen::MatrixXd step, int doublings) {
  for (int k = 0; k < doublings; ++k) {
    const Eigen::MatrixXd square = step * step;
    if (!(square.norm() < 1e100)) return std::numeric_limits<double>::infinity();
    step = square;
  }
  return step.norm() / std::sqrt(double(step.rows()));
}

double growth_rate(const Eigen::MatrixXd& step, int steps) {
  std::mt19937_64 random{1};
  Eigen::VectorXd state(step.rows());
  for (double& s : state) s = std::normal_distribution<>()(random);
  double log_growth = 0;
  for (int k = 0; k < steps; ++k) {
    if (2 * k == steps / 2 * 2) log_growth = 0;
    state = step * state.eval();
    const double norm = state.norm();
    log_growth += std::log(norm);
    state /= norm;
  }
  return std::exp(log_growth / (steps - steps / 2));
}

double true_limit(LinearStep& step) {
  double stable = step.certain(), unstable = 3 * stable;
  for (int k = 0; k < 9; ++k) {
    const double dt = (stable + unstable) / 2;
    (growth_rate(step.matrix(dt), 600) < 1.003 ? stable : unstable) = dt;
  }
  return (stable + unstable) / 2;
}

}  // namespace mpm::atlas
