// SPDX-License-Identifier: MIT
#include "particle.hpp"
#include <gtest/gtest.h>
#include <mpm/materials/presets.hpp>

namespace mpm::laws {
namespace {

using Rock = WithTensileLaw<JohnsonHolmquist2>;

/// A bar of one particle: axial strain given, sides free.
struct Bar {
  Particle<Rock, double> p{.law = granite_paper()};
  double lateral = 0;

  void pull(double axial) {
    double low = -.02, high = .02;
    for (int k = 0; k < 50; ++k) {
      lateral = (low + high) / 2;
      auto trial = p;
      trial.go(at(axial));
      (trial.stress().yy > 0 ? high : low) = lateral;
    }
    p.go(at(axial));
  }
  Tensor<double> at(double axial) const { return {1 + axial, 0, 0, 0, 1 + lateral, 0, 0, 0, 1 + lateral}; }
};

TEST(RankineSoftening, PeakIsTheStrengthAndTheAreaIsTheFractureEnergy) {
  for (const double strength : {54e6, 40e6})
    for (const double size : {5e-3, 2.5e-3}) {
      Bar bar;
      bar.p.state.strength = strength;
      bar.p.size = size;
      double peak = 0;
      const double end = 2 * 500 / (strength * size);  // e_f
      for (int i = 1; i <= 800; ++i) {
        bar.pull(1.02 * end * i / 800);
        peak = std::max(peak, bar.p.stress().xx);
        if (i != 400) continue;
        EXPECT_NEAR(bar.p.stress().xx, strength * (1 - .51) / (1 - strength / (51.18e9 * end)), .01 * strength);
      }
      EXPECT_NEAR(peak, strength, .01 * strength);
      EXPECT_LE(peak, strength * (1 + 1e-9));
      EXPECT_NEAR(bar.p.work * size, 500, 5);
      EXPECT_EQ(bar.p.state.cracking, 1);
      EXPECT_EQ(bar.p.state.damage, 0);
      EXPECT_NEAR(bar.p.stress().xx, 0, 1);
    }
}

TEST(RankineSoftening, ACrackClosesWithTheFullStiffnessAndOpensWeak) {
  Particle<Rock, double> cracked{.law = granite_paper()}, whole = cracked;
  cracked.dt = whole.dt = 1;
  const auto strained = [](double e) { return Tensor<double>{1 + e, 0, 0, 0, 1, 0, 0, 0, 1}; };
  for (int i = 1; i <= 300; ++i) cracked.go(strained(2e-3 * i / 300));
  const double d = cracked.state.cracking;
  EXPECT_GT(d, .5);
  EXPECT_LT(d, 1);
  for (int i = 299; i >= -300; --i) cracked.go(strained(2e-3 * i / 300));
  for (int i = -1; i >= -300; --i) whole.go(strained(2e-3 * i / 300));
  EXPECT_LT(whole.stress().xx, -50e6);
  EXPECT_NEAR(cracked.stress().xx, whole.stress().xx, 1e3);
  EXPECT_NEAR(cracked.stress().yy, whole.stress().yy, 1e3);
  EXPECT_EQ(cracked.state.cracking, d);
  for (int i = -299; i <= 150; ++i) cracked.go(strained(2e-3 * i / 300)), whole.go(strained(2e-3 * i / 300));
  EXPECT_GT(cracked.stress().xx, 0);
  EXPECT_LT(cracked.stress().xx, .6 * whole.stress().xx);
  EXPECT_EQ(cracked.state.cracking, d);
}

/// Radial compression passes along an open radial crack: sigma_xx = 0 across it, E along it.
TEST(RankineSoftening, AnOpenCrackIsAFreeSide) {
  auto law = granite_paper();
  law.K2 = law.K3 = 0;
  law.sigma_hel = 1e12;
  Particle<Rock, double> p{.law = law};
  p.dt = 1;
  for (int i = 1; i <= 100; ++i) p.go({1 + .2 * i / 100, 0, 0, 0, 1, 0, 0, 0, 1});
  ASSERT_EQ(p.state.cracking, 1);
  EXPECT_NEAR(largest(p.stress()), 0, 1e3);
  for (int i = 1; i <= 100; ++i) p.go({1.2, 0, 0, 0, 1 - 1e-3 * i / 100, 0, 0, 0, 1});
  EXPECT_NEAR(p.stress().xx, 0, 1e4);
  const double E = p.law.young_in_tension(), nu = E / (2 * p.law.shear()) - 1;
  EXPECT_NEAR(p.stress().yy, -1e-3 * E / (1 - nu * nu), 2e-3 * E * 1e-3);  // plane strain along z
  EXPECT_NEAR(p.stress().zz, nu * p.stress().yy, 2e-3 * E * 1e-3);
}

/// A shear crack: the crack opens normal to the larger principal stress, at 45 degrees, whatever the axes.
TEST(RankineSoftening, CracksFollowThePrincipalDirections) {
  Particle<Rock, double> p{.law = granite_paper()};
  p.dt = 1;
  for (int i = 1; i <= 200; ++i) p.go({1, 5e-3 * i / 200, 0, 5e-3 * i / 200, 1, 0, 0, 0, 1});
  EXPECT_GT(p.state.cracking, .99);
  EXPECT_NEAR(p.stress().xx, p.stress().yy, 1e5);
  const double across = p.stress().xx + p.stress().xy, along = p.stress().xx - p.stress().xy;
  EXPECT_NEAR(across, 0, 3e6);
  EXPECT_LT(along, -100e6);
}

TEST(RankineSoftening, SnapBackLimits) {
  const RankineSoftening tension{.strength = 54e6, .fracture_energy = 500};
  EXPECT_NEAR(tension.largest_size(51188.28e6, 54e6), 17.554e-3, 1e-6);
  EXPECT_NEAR(tension.largest_strength(51188.28e6, 17.554e-3), 54e6, 1e3);
  // Beyond the limit: brittle at the strength, never NaN, never above it.
  EXPECT_EQ(tension.damage(53.9e6, 54e6, 54.9e9, .1), 0);
  EXPECT_EQ(tension.damage(54.1e6, 54e6, 54.9e9, .1), 1);
}

}  // namespace
}  // namespace mpm::laws
