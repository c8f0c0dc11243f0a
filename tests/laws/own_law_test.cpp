// SPDX-License-Identifier: MIT
// The example's own law goes through the sweep of the shipped ones.
#include "law_sweep.hpp"
#include "von_mises.hpp"

MPM_SWEEP_LAW(OwnLaw, copper());

namespace {

/// Uniaxial strain: elastic to yield / 2G, then the pressure goes on rising and the deviator follows the hardening.
TEST(OwnLaw, YieldsWhereItMust) {
  const auto law = copper();
  const double G = mpm::shear_modulus(law.young, law.poisson), K = law.young / (3 * (1 - 2 * law.poisson));
  auto s = law.initial<double>();
  const double step = 1e-5;
  for (int i = 0; i < 1000; ++i) law.update(s, {.L = {.xx = step}, .dt = 1});
  const double strain = 1000 * step;
  const double plastic = (2 * G * strain - law.yield) / (3 * G + law.hardening);
  EXPECT_NEAR(mpm::trace(s.stress) / 3, K * strain, 1e-9 * K);
  EXPECT_NEAR(s.plastic_strain, plastic, 1e-9);
  EXPECT_NEAR(mpm::equivalent_stress(s.stress), law.yield + law.hardening * plastic, 1e-3);
}

}  // namespace
