// SPDX-License-Identifier: MIT
#include <mpm/analysis/noh.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

namespace {
using namespace mpm::analysis;

TEST(Noh, FiguresForFiveThirds) {
  constexpr double density[] = {4, 16, 64}, t = .6;
  for (int d = 1; d <= 3; ++d) {
    const Noh noh{.dimension = d};
    EXPECT_NEAR(noh.shock(t), t / 3, 1e-15);
    const GasState inside = noh.at(.19, t), outside = noh.at(.21, t);
    EXPECT_NEAR(inside.density, density[d - 1], 1e-12);
    EXPECT_EQ(inside.velocity, 0);
    EXPECT_NEAR(inside.pressure, density[d - 1] / 3, 1e-12);
    EXPECT_NEAR(inside.energy(5. / 3), .5, 1e-14);
    EXPECT_NEAR(outside.density, std::pow(1 + t / .21, d - 1), 1e-12);
    EXPECT_EQ(outside.velocity, -1);
    EXPECT_EQ(outside.pressure, 0);
  }
}

TEST(Noh, ShockConservesMassMomentumAndEnergy) {
  for (int d = 1; d <= 3; ++d) {
    const Noh noh{.dimension = d, .gamma = 1.4, .density = 1.2, .speed = 300};
    const double t = 2e-3, shock = noh.shock(t), speed = shock / t;
    const GasState behind = noh.at(.999999999999 * shock, t), ahead = noh.at(shock, t);
    const double flow = ahead.density * (speed - ahead.velocity);  // kg/(m2 s)
    EXPECT_NEAR(behind.density * speed / flow, 1, 1e-12) << d;
    EXPECT_NEAR(behind.pressure / (flow * 300), 1, 1e-12) << d;
    EXPECT_NEAR(behind.energy(1.4), 300. * 300 / 2, 1e-7) << d;
  }
}

/// What lay within 1 + t at the start lies within 1 at t.
TEST(Noh, ConservesMass) {
  constexpr int cells = 30000;
  const double t = 1.5;
  for (int d = 1; d <= 3; ++d) {
    const Noh noh{.dimension = d};
    double mass = 0;
    for (int i = 0; i < cells; ++i) {
      const double r = (i + .5) / cells;
      mass += noh.at(r, t).density * std::pow(r, d - 1) / cells;
    }
    EXPECT_NEAR(mass, std::pow(1 + t, d) / d, 1e-7 * mass) << d;
  }
}

TEST(Noh, RefusesNonsense) {
  EXPECT_THROW(Noh{.dimension = 4}.at(1, 1), std::invalid_argument);
  EXPECT_THROW(Noh{}.at(0, 1), std::invalid_argument);
  EXPECT_THROW(Noh{}.at(1, -1), std::invalid_argument);
}
}  // namespace
