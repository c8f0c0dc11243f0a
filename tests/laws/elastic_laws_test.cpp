// SPDX-License-Identifier: MIT
#include "particle.hpp"
#include <gtest/gtest.h>
#include <mpm/materials/neo_hookean.hpp>
#include <mpm/materials/presets.hpp>

namespace mpm::laws {
namespace {

TEST(PrincipalValues, OfARotatedDiagonal) {
  Random<double> random;
  for (const PrincipalValues<double> d :
       {PrincipalValues<double>{5, 2, -7}, {3, 3, -1}, {4, -2, -2}, {1, 1, 1}, {0, 0, 0}}) {
    const auto a = rotated(SymmetricTensor<double>{d.third, d.first, d.second, 0, 0, 0}, random.rotation());
    const auto found = principal_values(a);
    EXPECT_NEAR(found.first, d.first, 1e-6);
    EXPECT_NEAR(found.second, d.second, 1e-6);
    EXPECT_NEAR(found.third, d.third, 1e-6);
    EXPECT_NEAR(found.first + found.second + found.third, trace(a), 1e-13);
  }
  const auto apart = principal_values(rotated(SymmetricTensor<double>{5e9, 2e9, -7e9, 0, 0, 0}, random.rotation()));
  EXPECT_NEAR(apart.first, 5e9, 1e-2);
  EXPECT_NEAR(apart.third, -7e9, 1e-2);
}

TEST(Hypoelastic, UniaxialStrainIsLogarithmic) {
  Particle<Hypoelastic, double> p{.law = granite_elastic()};
  for (int i = 1; i <= 1000; ++i) p.go({1 + 2e-4 * i, 0, 0, 0, 1, 0, 0, 0, 1});
  const double mu = 51188.28e6 / (2 * 1.16818);
  EXPECT_NEAR(p.stress().xx, (51188.28e6 * .83182 / (1.16818 * .66364)) * std::log(1.2), 1e3);
  EXPECT_NEAR(p.stress().xx - p.stress().yy, 2 * mu * std::log(1.2), 1e3);
}

TEST(NeoHookean, StretchAndShear) {
  Particle<NeoHookean, double> p{.law = {.density = 1000, .young = 1000, .poisson = .3}};
  const double lambda = 576.923076923, mu = 384.615384615;
  p.go({1.2, 0, 0, 0, 1, 0, 0, 0, 1});
  EXPECT_NEAR(p.stress().xx, (lambda * std::log(1.2) + mu * .44) / 1.2, 1e-6);
  EXPECT_NEAR(p.stress().yy, lambda * std::log(1.2) / 1.2, 1e-6);
  p.go({1, 6.5, 0, 0, 1, 0, 0, 0, 1});
  EXPECT_NEAR(p.stress().xy, 6.5 * mu, 1e-6);
  EXPECT_NEAR(p.stress().xx, 42.25 * mu, 1e-6);
}

/// Shear of 6 to 7 takes the wave to about four times its speed at rest: a step from constants would be unsafe.
TEST(NeoHookean, ShearStiffens) {
  Particle<NeoHookean, double> p{.law = {.density = 1000, .young = 1000, .poisson = .3}};
  const double rest = p.tangent().longitudinal;
  EXPECT_NEAR(rest, 576.923076923 + 2 * 384.615384615, 1e-6);
  p.go({1, 6.5, 0, 0, 1, 0, 0, 0, 1});
  const double b = 1 + 6.5 * 6.5 / 2 + 6.5 * std::sqrt(1 + 6.5 * 6.5 / 4);  // largest principal value of F F^T
  EXPECT_NEAR(p.tangent().longitudinal, 576.923076923 + 384.615384615 * (1 + b), 1e-3);
  EXPECT_NEAR(p.tangent().shear, 384.615384615 * b, 1e-3);
  EXPECT_NEAR(std::sqrt(p.tangent().longitudinal / rest), 3.6, .1);
}

TEST(BulkViscosity, ClosesOnly) {
  const BulkViscosity viscosity;
  EXPECT_EQ(viscosity.pressure(1000., 2000., 5., .01), 0);
  // rho h rate (c1 c + c0 h rate) = 1000 x .01 x 1e5 x (120 + 1500)
  EXPECT_NEAR(viscosity.pressure(1000., 2000., -1e5, .01), 1.62e9, 1);
  EXPECT_EQ(viscosity.step_factor(2000., 1e5, .01), 1);
  EXPECT_NEAR(viscosity.step_factor(2000., -1e5, .01), std::sqrt(1 + .81 * .81) - .81, 1e-12);
}

}  // namespace
}  // namespace mpm::laws
