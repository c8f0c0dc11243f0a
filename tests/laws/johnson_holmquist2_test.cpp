// SPDX-License-Identifier: MIT
#include "particle.hpp"
#include <gtest/gtest.h>
#include <mpm/materials/presets.hpp>

namespace mpm::laws {
namespace {

constexpr JohnsonHolmquist2 ceramic() {
  const double K = 130.95e9, G = 90.16e9, E = young_modulus(K, G);
  return {.density = 3700,
          .young = E,
          .poisson = E / (2 * G) - 1,
          .K1 = K,
          .A = .93,
          .N = .6,
          .B = .31,
          .M = .6,
          .tensile_pressure = .2e9,
          .sigma_hel = 1.5 * (2.79e9 - 1.46e9),
          .p_hel = 1.46e9,
          .D1 = .005,
          .D2 = 1,
          .beta = 1,
          .viscosity = {0, 0}};
}

/// Uniaxial compression of a published-style ceramic against an implementation of its own.
TEST(JohnsonHolmquist2, CeramicInUniaxialStrain) {
  Particle<JohnsonHolmquist2, double> p{.law = ceramic()};
  p.dt = 1;
  const int steps = 50000;
  double yield = 0, fractured = 0;
  for (int i = 1; i <= steps; ++i) {
    p.go({1 - .05 * i / steps, 0, 0, 0, 1, 0, 0, 0, 1});
    const double q = equivalent_stress(p.stress()), P = -trace(p.stress()) / 3;
    if (yield == 0 && p.state.damage > 0) {
      yield = 1 - p.J;
      EXPECT_NEAR(q, 2.00911e9, 1e5);
    }
    if (fractured == 0 && p.state.damage == 1) fractured = 1 - p.J;
    if (i == steps * 2 / 5) {
      EXPECT_NEAR(-p.stress().xx, 4.45917e9, 1e5);
      EXPECT_NEAR(P, 2.96605e9, 1e5);
      EXPECT_NEAR(p.state.damage, .35516, 2e-5);
    }
  }
  EXPECT_NEAR(yield, .011080, 2e-6);
  EXPECT_NEAR(fractured, .039232, 2e-6);
  EXPECT_NEAR(-p.stress().xx, 8.64212e9, 1e5);
  EXPECT_NEAR(-trace(p.stress()) / 3, 7.53814e9, 1e5);
  EXPECT_NEAR(p.state.bulking, .64604e9, 1e4);
  EXPECT_EQ(p.state.damage, 1);
}

TEST(JohnsonHolmquist2, TensionIsCappedAndCrushesTheRock) {
  Particle<JohnsonHolmquist2, double> p{.law = granite_paper()};
  for (int i = 1; i <= 100; ++i) {
    p.go(std::cbrt(1 + 1e-4 * i) * Tensor<double>::identity());
    EXPECT_NEAR(trace(p.stress()) / 3, std::min(25.7e9 * (1 - 1 / p.J), 54e6), 1);
  }
  p.go(p.F + Tensor<double>{1e-4, 0, 0, 0, -1e-4, 0, 0, 0, 0});  // any shear breaks it at once
  p.settle(2);
  EXPECT_EQ(p.state.damage, 1);
  EXPECT_EQ(largest(p.stress()), 0);
}

/// Ten thousand times the reference rate: strength 1 + .005 ln(1e4) = 1.04605 of the slow one, at the same pressure.
TEST(JohnsonHolmquist2, StrengthRisesWithTheRate) {
  double q[2];
  for (int fast = 0; fast < 2; ++fast) {
    auto law = JohnsonHolmquist2(granite_paper());
    law.D1 = 1e9;
    Particle<JohnsonHolmquist2, double> p{.law = law};
    const double rate = fast ? 1e4 : 1;  // equivalent rate of simple shear g: g/sqrt 3
    p.dt = 1e-3 / rate;
    for (int i = 0; i < 100; ++i) p.step({0, std::sqrt(3.) * rate, 0, 0, 0, 0, 0, 0, 0}, p.F);
    q[fast] = equivalent_stress(p.stress());
  }
  EXPECT_NEAR(q[1] / q[0], 1 + .005 * std::log(1e4), 1e-4);
}

/// Unconfined strength of the presets: y at a pressure of a third of itself.
TEST(JohnsonHolmquist2, UnconfinedStrengthOfThePresets) {
  const auto strength = [](const JohnsonHolmquist2& rock) {
    double y = 300e6;
    for (int i = 0; i < 100; ++i)
      y = rock.sigma_hel * rock.A * std::pow((y / 3 + rock.tensile_pressure) / rock.p_hel, rock.N);
    return y;
  };
  for (const auto& rock : {granite_1200(), granite_3000(), granite_paper()}) {
    Particle<JohnsonHolmquist2, double> p{.law = rock};
    p.dt = 1;
    p.law.viscosity = {0, 0};
    double highest = 0, lateral = 0;
    for (int i = 1; i <= 3000 && p.state.damage == 0; ++i) {
      const double axial = -1e-5 * i;
      for (int k = 0; k < 30; ++k) {  // lateral strain that leaves the sides free
        auto trial = p;
        trial.go({1 + axial, 0, 0, 0, 1 + lateral, 0, 0, 0, 1 + lateral});
        lateral -= trial.stress().yy / 60e9;
      }
      p.go({1 + axial, 0, 0, 0, 1 + lateral, 0, 0, 0, 1 + lateral});
      highest = std::max(highest, -p.stress().xx);
    }
    EXPECT_NEAR(highest, strength(rock), .01 * strength(rock));
  }
  EXPECT_NEAR(strength(granite_3000()), 340e6, 10e6);
}

TEST(JohnsonHolmquist2, RelativeVolumeInvertsTheEquationOfState) {
  const auto rock = granite_paper();
  for (const double p : {-50e6, 0., 1e6, 20e6, 60e6, 120e6, 3.7e9, 18e9})
    EXPECT_NEAR(rock.pressure(1 / rock.relative_volume(p) - 1), p, 1e-6 * std::abs(p) + 1e-3);
  // Not linear: at 40 MPa the linear curve would give mu = .001556.
  EXPECT_NEAR(1 / rock.relative_volume(40e6) - 1, .00237, .00005);
  EXPECT_THROW(rock.relative_volume(-26e9), std::domain_error);
  EXPECT_THROW(rock.relative_volume(std::nan("")), std::domain_error);
}

/// The stiffening that makes a step from a constant speed unsafe, m/s.
TEST(JohnsonHolmquist2, SoundSpeedOfGranite) {
  const auto rock = granite_paper();
  const auto speed = [&](double p) {
    const double J = rock.relative_volume(p);
    auto s = rock.state_of(SymmetricTensor<double>::spherical(-p));
    return std::sqrt(rock.tangent(s, J).longitudinal * J / rock.density);
  };
  EXPECT_NEAR(speed(0), 4544, 1);
  EXPECT_NEAR(speed(3.7e9), 13.7e3, 100);
  EXPECT_NEAR(speed(14e9), 21e3, 200);
}

}  // namespace
}  // namespace mpm::laws
