// SPDX-License-Identifier: MIT
#include <problems/plane_detonation.hpp>
#include <gtest/gtest.h>
#include <Eigen/Dense>

// The Taylor wave behind a plane detonation (Taylor 1950).
namespace {

using namespace mpm;
using problems::BurnedParticle;
using Profile = std::vector<BurnedParticle>;

const double cj = petn_1260().chapman_jouguet().pressure;

template <class Shape, class Integrator>
Profile profile(int cells, double distance, const Integrator& integrator) {
  Profile result;
  problems::plane_detonation<Shape>({.cells = cells, .distance = distance}, integrator, &result);
  return result;
}

/// x/(D t) where the pressure falls through half of the CJ pressure.
double front(const Profile& particles) {
  for (std::size_t i = particles.size() - 1; i > 0; --i) {
    const auto &a = particles[i - 1], &b = particles[i];
    if (a.pressure >= cj / 2)
      return a.position + (b.position - a.position) * (a.pressure - cj / 2) / (a.pressure - b.pressure);
  }
  return 0;
}
/// Relative error of the pressure between two places, in the mean over the particles.
double error(const Profile& particles, double from, double to) {
  double sum = 0, exact = 0;
  for (const auto& [position, pressure, right] : particles)
    if (position >= from && position <= to) sum += pressure, exact += right;
  return sum / exact - 1;
}
/// Relative error of the pressure at x = D t of the parabola through the Taylor wave from .75 to .93, short of the
/// burn.
double extrapolated_error(const Profile& particles) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const auto& [position, pressure, right] : particles) {
    if (position < .75 || position > .93) continue;
    const Eigen::Vector3d terms{1, position - 1, (position - 1) * (position - 1)};
    A += terms * terms.transpose();
    b += pressure * terms;
  }
  return A.ldlt().solve(b)[0] / cj - 1;
}

struct Errors {
  double speed, at_nine_tenths, rest, peak;
};
template <class Shape, class Integrator>
Errors detonation(int cells, const Integrator& integrator) {
  const Profile half = profile<Shape>(cells, .49, integrator), whole = profile<Shape>(cells, .98, integrator);
  return {2 * front(whole) - front(half) - 1, error(whole, .88, .92), error(whole, .1, .4), extrapolated_error(whole)};
}

// Asked at 100 cells: .3, 1, 1 and 3 %.
TEST(PlaneDetonation, SplinesFollowTheTaylorWave) {
  const Errors e = detonation<QuadraticBspline>(100, Fmpm{.order = 4});
  EXPECT_LT(std::abs(e.speed), .003);
  EXPECT_LT(std::abs(e.at_nine_tenths), .01);
  EXPECT_LT(std::abs(e.rest), .003);
  EXPECT_LT(std::abs(e.peak), .013);
}

// The burn takes a cell and a half, so the wave starts that much late: an error of order one.
TEST(PlaneDetonation, BoxesFollowAtOrderOne) {
  const Errors coarse = detonation<Ugimp>(100, Musl{}), fine = detonation<Ugimp>(200, Musl{});
  EXPECT_LT(std::abs(coarse.speed), .003);
  EXPECT_NEAR(coarse.at_nine_tenths, .032, .005);
  EXPECT_NEAR(std::log2(coarse.at_nine_tenths / fine.at_nine_tenths), 1.1, .3);
  EXPECT_LT(std::abs(coarse.rest), .007);
  EXPECT_LT(std::abs(fine.rest), .003);
  EXPECT_LT(std::abs(fine.peak), .03);
}

}  // namespace
