// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

namespace mpm::atlas {

/// The step of a small solver at rest, which is linear for motions too small to move anything. The squared norm of a
/// state, the particles' velocities and stresses, is about twice its energy.
class RestingStep {
 public:
  virtual ~RestingStep() = default;
  /// The solver's own step of particles at rest, at safety 1.
  virtual double certain() const = 0;
  /// The same by Irons' bound, a particle at a time, which is the step of particles that move.
  virtual double irons() const = 0;
  /// 2/w of the highest frequency w of the nodes with their lumped masses: the limit where velocities never leave them.
  virtual double nodal_limit() = 0;
  /// Growth a step of the norm of a random state, over the last half of so many steps `dt`, or of fewer where it is
  /// beyond 1e88; infinite where that stops the run. Tells no growth from one of less than about 1 + 1/steps.
  virtual double growth_rate(double dt, int steps) = 0;
  /// What becomes of each velocity and stress component of each particle in a step `dt`, so that whether it grows is no
  /// matter of where a run started. Components are scaled by sqrt(m) and sqrt(V/M), M the longitudinal modulus. Only
  /// where a step hands on nothing else.
  virtual Eigen::MatrixXd matrix(double dt) = 0;
};

/// Root mean square growth of all states over 2^doublings steps: the Frobenius norm of that power of the matrix over
/// that of the identity; infinite once it is beyond 1e100.
double growth(Eigen::MatrixXd step, int doublings);

/// The step beyond which motions grow, by bisection upwards from the certain step; no more than 64 times that.
double true_limit(RestingStep& step);

}  // namespace mpm::atlas
