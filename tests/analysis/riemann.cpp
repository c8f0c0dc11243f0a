// SPDX-License-Identifier: MIT
#include <mpm/analysis/riemann.hpp>
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <stdexcept>

namespace {
using namespace mpm::analysis;

TEST(Riemann, StarValuesOfSod) {
  const RiemannStar s = Riemann{}.star();
  EXPECT_NEAR(s.pressure, .30313018, 5e-9);
  EXPECT_NEAR(s.velocity, .92745262, 5e-9);
  EXPECT_NEAR(s.density_left, .42631943, 5e-9);
  EXPECT_NEAR(s.density_right, .26557371, 5e-9);
  EXPECT_NEAR(s.right.head, 1.75215573, 5e-9);
  EXPECT_EQ(s.right.tail, s.right.head);
  EXPECT_NEAR(s.left.head, -std::sqrt(1.4), 1e-15);
}

/// Toro's tests 2 to 5 (his table 4.3): two rarefactions, two strong shock tubes, two shocks.
TEST(Riemann, StarValuesOfTorosTests) {
  struct Row {
    GasState left, right;
    double p, u, density_left, density_right;
  };
  constexpr Row table[] = {
      {{1, -2, .4}, {1, 2, .4}, .00189, 0, .02185, .02185},
      {{1, 0, 1000}, {1, 0, .01}, 460.894, 19.5975, .57506, 5.99924},
      {{1, 0, .01}, {1, 0, 100}, 46.0950, -6.19633, 5.99242, .57511},
      {{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1691.64, 8.68975, 14.2823, 31.0426}};
  for (const Row& row : table) {
    const RiemannStar s = Riemann{row.left, row.right, 1.4}.star();
    EXPECT_NEAR(s.pressure, row.p, 1e-5 * row.p + 5e-6);
    EXPECT_NEAR(s.velocity, row.u, 5e-5);
    EXPECT_NEAR(s.density_left, row.density_left, 5e-6 * row.density_left + 5e-6);
    EXPECT_NEAR(s.density_right, row.density_right, 5e-6 * row.density_right + 5e-6);
  }
}

std::array<double, 3> conserved(const GasState& g, double gamma) {
  return {g.density, g.density * g.velocity, g.density * (g.energy(gamma) + 0.5 * g.velocity * g.velocity)};
}
std::array<double, 3> flux(const GasState& g, double gamma) {
  const auto q = conserved(g, gamma);
  return {q[1], q[1] * g.velocity + g.pressure, (q[2] + g.pressure) * g.velocity};
}

void expect_conserved(const Riemann& tube) {
  constexpr int cells = 20000;
  const double half = 10, dx = 2 * half / cells;  // all waves stay within
  std::array<double, 3> sum{};
  for (int i = 0; i < cells; ++i) {
    const auto q = conserved(tube.at(-half + (i + .5) * dx), tube.gamma);
    for (int k = 0; k < 3; ++k) sum[k] += q[k] * dx;
  }
  const auto ql = conserved(tube.left, tube.gamma), qr = conserved(tube.right, tube.gamma);
  const auto fl = flux(tube.left, tube.gamma), fr = flux(tube.right, tube.gamma);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum[k], half * (ql[k] + qr[k]) + fl[k] - fr[k], 4e-3) << k;
}

TEST(Riemann, ProfileConservesMassMomentumAndEnergy) {
  expect_conserved({});
  expect_conserved({{1, 2, .5}, {.6, -1, 1.2}, 5. / 3});  // two shocks
  expect_conserved({{1, -.5, 1}, {.6, .7, .8}, 1.2});     // two rarefactions
  expect_conserved({{.125, 3, .1}, {1, 2.5, 1}, 1.4});    // rarefaction to the right, all swept along
}

TEST(Riemann, ShockObeysRankineAndHugoniot) {
  const Riemann tube{};
  const double shock = tube.star().right.head;
  const GasState ahead = tube.at(shock + 1e-9), behind = tube.at(shock - 1e-9);
  const auto qa = conserved(ahead, 1.4), qb = conserved(behind, 1.4);
  const auto fa = flux(ahead, 1.4), fb = flux(behind, 1.4);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(fb[k] - fa[k], shock * (qb[k] - qa[k]), 1e-13) << k;
}

TEST(Riemann, FanIsIsentropicAndSelfSimilar) {
  const Riemann tube{};
  for (const double speed : {-1.1, -.7, -.3, -.08}) {
    const GasState g = tube.at(speed);
    const double c = std::sqrt(1.4 * g.pressure / g.density);
    EXPECT_NEAR(g.velocity - c, speed, 1e-14);
    EXPECT_NEAR(g.velocity + 5 * c, 5 * std::sqrt(1.4), 1e-14);
    EXPECT_NEAR(g.pressure, std::pow(g.density, 1.4), 1e-14);
  }
}

TEST(Riemann, MirrorsAndMovesWithItsFrame) {
  const Riemann tube{}, mirror{{.125, 0, .1}, {1, 0, 1}, 1.4}, moving{{1, 3, 1}, {.125, 3, .1}, 1.4};
  for (const double speed : {-2., -.5, 0., .5, 1.2, 1.7, 2.}) {
    const GasState g = tube.at(speed), m = mirror.at(-speed), f = moving.at(speed + 3);
    EXPECT_NEAR(m.density, g.density, 1e-14) << speed;
    EXPECT_NEAR(m.velocity, -g.velocity, 1e-14) << speed;
    EXPECT_NEAR(m.pressure, g.pressure, 1e-14) << speed;
    EXPECT_NEAR(f.density, g.density, 1e-13) << speed;
    EXPECT_NEAR(f.velocity, g.velocity + 3, 1e-13) << speed;
  }
}

TEST(Riemann, EqualStatesStayAsTheyAre) {
  const RiemannStar s = Riemann{{2, 1, 3}, {2, 1, 3}, 1.4}.star();
  EXPECT_NEAR(s.pressure, 3, 1e-14);
  EXPECT_NEAR(s.velocity, 1, 1e-15);
}

TEST(Riemann, RefusesVacuumAndNonsense) {
  const double escape = 10 * std::sqrt(1.4 * .4);  // 2 (cl + cr)/(gamma - 1) of Toro's second test
  EXPECT_NEAR((Riemann{{1, 0, .4}, {1, .9 * escape, .4}, 1.4}.star().velocity), .45 * escape, 1e-12);
  EXPECT_THROW((Riemann{{1, 0, .4}, {1, 1.0001 * escape, .4}, 1.4}.at(0)), std::invalid_argument);
  EXPECT_THROW((Riemann{{1, 0, 0}, {1, 0, 1}, 1.4}.star()), std::invalid_argument);
  EXPECT_THROW((Riemann{{1, 0, 1}, {1, 0, 1}, 1}.star()), std::invalid_argument);
}
}  // namespace
