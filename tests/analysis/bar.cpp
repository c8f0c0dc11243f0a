// SPDX-License-Identifier: MIT
#include <mpm/analysis/bar.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace {
using namespace mpm::analysis;
constexpr AxialBar bar{};

TEST(AxialBar, StartsUnstrainedAndSwingsInTenSeconds) {
  EXPECT_NEAR(bar.velocity(25, 0), .1, 1e-16);
  EXPECT_NEAR(bar.velocity(10, 0), .1 * std::sin(std::numbers::pi * 10 / 50), 1e-16);
  EXPECT_EQ(bar.displacement(10, 0), 0);
  EXPECT_NEAR(bar.period(), 10, 1e-14);
  EXPECT_NEAR(bar.velocity(25, 10), .1, 1e-14);
  EXPECT_NEAR(bar.displacement(25, 2.5), .5 / std::numbers::pi, 1e-14);  // v0/omega, omega = pi/5
}

TEST(AxialBar, HoldsItsEnds) {
  for (double t = .3; t < 12; t += 1.1) {
    EXPECT_EQ(bar.displacement(0, t), 0);
    EXPECT_NEAR(bar.stress(25, t), 0, 1e-15);
  }
}

TEST(AxialBar, ObeysHookeAndMomentum) {
  const AxialBar rock{.length = 3, .young = 50e9, .density = 2660, .speed = .2};
  const double X = 1.1, t = .3 * rock.period(), h = 1e-4, dt = 1e-4 * rock.period();
  const double strain = (rock.displacement(X + h, t) - rock.displacement(X - h, t)) / (2 * h);
  EXPECT_NEAR(rock.stress(X, t) / (50e9 * strain), 1, 1e-8);
  const double rate = (rock.displacement(X, t + dt) - rock.displacement(X, t - dt)) / (2 * dt);
  EXPECT_NEAR(rock.velocity(X, t) / rate, 1, 1e-6);
  const double inertia = 2660 * (rock.velocity(X, t + dt) - rock.velocity(X, t - dt)) / (2 * dt);
  const double force = (rock.stress(X + h, t) - rock.stress(X - h, t)) / (2 * h);
  EXPECT_NEAR(inertia / force, 1, 1e-6);
}

TEST(AxialBar, KeepsItsEnergy) {
  constexpr int cells = 1000;
  for (const double t : {0., 1., 2.5, 4.2}) {
    double sum = 0;
    for (int i = 0; i < cells; ++i) {
      const double X = (i + .5) * 25. / cells, v = bar.velocity(X, t), s = bar.stress(X, t);
      sum += 25. / cells * (.5 * v * v + s * s / 200);
    }
    EXPECT_NEAR(sum, bar.energy(), 1e-9) << t;
  }
}
}  // namespace
