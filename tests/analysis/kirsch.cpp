// SPDX-License-Identifier: MIT
#include <mpm/analysis/kirsch.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <utility>

namespace {
using namespace mpm::analysis;
constexpr double pi = std::numbers::pi;
constexpr Kirsch hole{.horizontal = -10e6, .vertical = -40e6, .radius = 0.021};

TEST(Polar, ComponentsOfAKnownStressAndBack) {
  const PlanarStress s{3, -1, 0.5};
  const PolarStress at45 = to_polar(s, pi / 4);  // n = (1, 1)/sqrt 2, t = (-1, 1)/sqrt 2
  EXPECT_NEAR(at45.rr, 1.5, 1e-15);
  EXPECT_NEAR(at45.tt, 0.5, 1e-15);
  EXPECT_NEAR(at45.rt, -2, 1e-15);
  const PlanarStress back = to_cartesian(to_polar(s, 0.7), 0.7);
  EXPECT_NEAR(back.xx, s.xx, 1e-14);
  EXPECT_NEAR(back.yy, s.yy, 1e-14);
  EXPECT_NEAR(back.xy, s.xy, 1e-14);
}

TEST(Kirsch, WallHoopStressOnTheAxes) {
  const double a = hole.radius;
  EXPECT_NEAR(hole.polar_stress(a, 0).tt, 3 * -40e6 + 10e6, 1);
  EXPECT_NEAR(hole.polar_stress(a, pi / 2).tt, 3 * -10e6 + 40e6, 1);
  EXPECT_NEAR(hole.stress(a, 0).yy, -110e6, 1);
  EXPECT_NEAR(hole.stress(0, a).xx, 10e6, 1);
}

TEST(Kirsch, WallCarriesNoTraction) {
  for (double theta = -3; theta < 3; theta += 0.31) {
    const PolarStress s = hole.polar_stress(hole.radius, theta);
    EXPECT_NEAR(s.rr, 0, 1e-6);
    EXPECT_NEAR(s.rt, 0, 1e-6);
  }
}

TEST(Kirsch, FarFieldIsUndisturbed) {
  for (double theta = 0; theta < 3; theta += 0.5) {
    const PlanarStress s = hole.stress(1e4 * std::cos(theta), 1e4 * std::sin(theta));
    EXPECT_NEAR(s.xx, -10e6, 1);
    EXPECT_NEAR(s.yy, -40e6, 1);
    EXPECT_NEAR(s.xy, 0, 1);
    EXPECT_NEAR(hole.stress_zz(1e4 * std::cos(theta), 1e4 * std::sin(theta), 0.2), 0.2 * -50e6, 1);
  }
}

// Turned by 30 degrees, tension across it is sheared positively: sigma_xy = (horizontal - vertical)/2 sin 60.
TEST(Kirsch, TurnsWithItsDirection) {
  Kirsch turned = hole;
  turned.direction = pi / 6;
  EXPECT_NEAR(turned.far_field().xx, -17.5e6, 1);
  EXPECT_NEAR(turned.far_field().yy, -32.5e6, 1);
  EXPECT_NEAR(turned.far_field().xy, 15e6 * std::sqrt(3.) / 2, 1);
  EXPECT_NEAR(turned.stress(1e4, 2e4).xy, turned.far_field().xy, 1);
  EXPECT_NEAR(turned.polar_stress(hole.radius, pi / 6).tt, -110e6, 1);
  EXPECT_NEAR(turned.polar_stress(.03, 1.1).rt, hole.polar_stress(.03, 1.1 - pi / 6).rt, 1);
  EXPECT_EQ(turned.displacement(.03, 1.1, 20e9, .2).t, hole.displacement(.03, 1.1 - pi / 6, 20e9, .2).t);
}

TEST(Kirsch, IsInEquilibrium) {
  const double h = 1e-6, x = 0.02, y = 0.017;
  const PlanarStress east = hole.stress(x + h, y), west = hole.stress(x - h, y);
  const PlanarStress north = hole.stress(x, y + h), south = hole.stress(x, y - h);
  const double scale = std::abs(east.xx - west.xx);
  EXPECT_GT(scale, 1e3);
  EXPECT_NEAR(east.xx - west.xx + north.xy - south.xy, 0, 1e-6 * scale);
  EXPECT_NEAR(east.xy - west.xy + north.yy - south.yy, 0, 1e-6 * scale);
}

TEST(Kirsch, DisplacementGivesTheStressByHooke) {
  const double shear = 20e9, nu = 0.2, lambda = 2 * shear * nu / (1 - 2 * nu), h = 1e-6;
  const auto u = [&](double r, double t) { return hole.displacement(r, t, shear, nu); };
  for (const auto& [r, t] : {std::pair{0.025, 0.4}, {0.04, 1.2}, {0.021, 2.5}}) {
    const double err = (u(r + h, t).r - u(r - h, t).r) / (2 * h);
    const double ett = u(r, t).r / r + (u(r, t + h).t - u(r, t - h).t) / (2 * h * r);
    const double ert = 0.5 * ((u(r, t + h).r - u(r, t - h).r) / (2 * h * r) +
                              (u(r + h, t).t - u(r - h, t).t) / (2 * h) - u(r, t).t / r);
    const PolarStress s = hole.polar_stress(r, t), s0 = to_polar({hole.horizontal, hole.vertical, 0}, t);
    EXPECT_NEAR(lambda * (err + ett) + 2 * shear * err, s.rr - s0.rr, 100);
    EXPECT_NEAR(lambda * (err + ett) + 2 * shear * ett, s.tt - s0.tt, 100);
    EXPECT_NEAR(2 * shear * ert, s.rt - s0.rt, 100);
  }
}

TEST(Kirsch, HoleInCompressedRockCloses) {
  const Kirsch even{.horizontal = -20e6, .vertical = -20e6, .radius = 0.02};
  EXPECT_NEAR(even.displacement(0.02, 1, 20e9, 0.2).r, -20e6 * 0.02 / 40e9, 1e-18);
}
}  // namespace
