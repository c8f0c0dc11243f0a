// SPDX-License-Identifier: MIT
#include <mpm/analysis/kirsch.hpp>
#include <mpm/analysis/ring_fit.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {
using namespace mpm::analysis;
constexpr double a = 0.021, centre_x = 0.3, centre_y = -0.2;

struct Particles {
  std::vector<double> x, y, volume, xx, yy, xy;

  void add(double r, double theta, double v, const PolarStress& polar) {
    const PlanarStress s = to_cartesian(polar, theta);
    x.push_back(centre_x + r * std::cos(theta)), y.push_back(centre_y + r * std::sin(theta));
    volume.push_back(v), xx.push_back(s.xx), yy.push_back(s.yy), xy.push_back(s.xy);
  }
  StressSamples samples() const { return {x, y, volume, xx, yy, xy, centre_x, centre_y}; }
};

/// A quarter of rock, particles at random, with the stress `field(r, theta)`.
template <class Field>
Particles quarter(const Field& field) {
  Particles p;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const double r = a * (1 + 3 * uniform(random)), theta = 0.5 * std::numbers::pi * uniform(random);
    p.add(r, theta, 0.5 + uniform(random), field(r, theta));
  }
  return p;
}

TEST(FitRing, ReproducesQuadraticsInTheRadius) {
  const double r0 = 2 * a;
  const auto p = quarter([&](double r, double) {
    const double d = (r - r0) / a;
    return PolarStress{-3e6 + 2e6 * d - 5e6 * d * d, 4e6 - 1e6 * d + 7e6 * d * d, 1e6 * d};
  });
  const PolarStress s = fit_ring(p.samples(), r0, 0.5 * a);
  EXPECT_NEAR(s.rr, -3e6, 1e-3);
  EXPECT_NEAR(s.tt, 4e6, 1e-3);
  EXPECT_NEAR(s.rt, 0, 1e-3);
}

TEST(FitRing, ReadsACavityWithinAPercent) {
  const auto p = quarter([](double r, double) { return PolarStress{-(a * a) / (r * r), (a * a) / (r * r), 0}; });
  const PolarStress s = fit_ring(p.samples(), 2 * a, 0.25 * a);
  EXPECT_NEAR(s.rr, -0.25, 1e-3);
  EXPECT_NEAR(s.tt, 0.25, 1e-3);
}

TEST(FitRing, WeighsByVolumeAndLooksNoFurtherThanTheWindow) {
  Particles p;
  for (const double d : {-1.0, -0.5, 0.3, 0.9})
    for (const double theta : {0.2, 1.1}) {
      p.add(1 + 0.1 * d, theta, 3, {8, -4, 0});
      p.add(1 + 0.1 * d, theta, 1, {0, 0, 0});
      p.add(1.101, theta, 100, {1e9, 1e9, 0});
    }
  const PolarStress s = fit_ring(p.samples(), 1, 0.1001);
  EXPECT_NEAR(s.rr, 6, 1e-9);
  EXPECT_NEAR(s.tt, -3, 1e-9);
}

TEST(FitWall, HoldsTheKirschFieldExactly) {
  for (const double k : {0.25, 1.0, 3.0}) {
    const Kirsch hole{.horizontal = -40e6 * k, .vertical = -40e6, .radius = a};
    const auto p = quarter([&](double r, double theta) { return hole.polar_stress(r, theta); });
    const WallStress wall = fit_wall(p.samples(), a, 0.4 * a);
    EXPECT_NEAR(wall.hoop.at(0), 3 * -40e6 + 40e6 * k, 1);
    EXPECT_NEAR(wall.hoop.at(std::numbers::pi / 2), 3 * -40e6 * k + 40e6, 1);
    EXPECT_NEAR(wall.hoop.mean, -40e6 * (1 + k), 1);
    EXPECT_NEAR(wall.hoop.cos2, -2 * -40e6 * (k - 1), 1);
    EXPECT_NEAR(wall.radial.mean, 0, 1);
    EXPECT_NEAR(wall.radial.cos2, 0, 1);
  }
}

/// The message of the error that `call` must throw.
template <class Error, class Call>
std::string message(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(FitRing, NamesARingWithTooFewParticles) {
  Particles p;
  p.add(1, 0.1, 1, {1, 2, 3});
  p.add(1.05, 0.2, 1, {1, 2, 3});
  const auto text = message<std::runtime_error>([&] { fit_ring(p.samples(), 1, 0.1); });
  EXPECT_NE(text.find("fit_ring: r = 1.0"), std::string::npos) << text;
  EXPECT_NE(text.find("the 2 particles there do not determine 3 coefficients"), std::string::npos) << text;
  for (int i = 0; i < 50; ++i) p.add(1, 0.01 * i, 1, {1, 2, 3});  // two radii do not make a parabola
  EXPECT_THROW(fit_ring(p.samples(), 1, 0.1), std::runtime_error);
  EXPECT_THROW(fit_wall(p.samples(), 0.9, 0.3), std::runtime_error);
}

TEST(FitWall, RefusesAWideWindowAndUnequalColumns) {
  auto p = quarter([](double, double) { return PolarStress{1, 1, 0}; });
  EXPECT_THROW(fit_wall(p.samples(), a, 0.6 * a), std::invalid_argument);
  EXPECT_THROW(fit_wall(p.samples(), a, 0), std::invalid_argument);
  p.xy.pop_back();
  const auto text = message<std::invalid_argument>([&] { fit_wall(p.samples(), a, 0.4 * a); });
  EXPECT_NE(text.find("2000 and 1999"), std::string::npos) << text;
}
}  // namespace
