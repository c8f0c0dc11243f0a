// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

namespace mpm::atlas {

/// One step of a small solver as a matrix, so that whether it grows is a matter of the matrix and not of where a run
/// started: what becomes of each velocity and stress component of each particle, for motions too small to move
/// anything. Components are scaled by sqrt(m) and sqrt(V/M), M the longitudinal modulus, so that the squared norm is
/// about twice the energy.
class LinearStep {
 public:
  virtual ~LinearStep() = default;
  /// The solver's own step of particles at rest, at safety 1.
  virtual double certain() const = 0;
  /// The same by Irons' bound, a particle at a time, which is the step of particles that move.
  virtual double irons() const = 0;
  /// 2/w of the highest frequency w of the nodes with their lumped masses: the limit where velocities never leave them.
  virtual double nodal_limit() = 0;
  /// The matrix of a step `dt`.
  virtual Eigen::MatrixXd matrix(double dt) = 0;
};

/// Root mean square growth of all states over 2^doublings steps: the Frobenius norm of that power of the matrix over
/// that of the identity; infinite once it is beyond 1e100.
double growth(Eigen::MatrixXd step, int doublings);

/// Growth a step of a random state, over the last half of so many steps. Costs less than `growth` where matrices are
/// large, and tells no growth from one of less than about 1 + 1/steps.
double growth_rate(const Eigen::MatrixXd& step, int steps);

/// The step beyond which motions grow, by bisection between the certain step and three times as much, where all are
/// taken to grow.
double true_limit(LinearStep& step);

}  // namespace mpm::atlas
