// SPDX-License-Identifier: MIT
#include <mpm/analysis/detonation.hpp>
#include <mpm/materials/presets.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

namespace {
using namespace mpm;
using namespace mpm::analysis;

constexpr JonesWilkinsLee tnt{
    .density = 1630, .A = 371.2e9, .B = 3.231e9, .R1 = 4.15, .R2 = .95, .omega = .3, .initial_energy = 7e9};

/// Energy per initial volume that the law's own equation of state assigns to a state, J/m3.
double energy(const JonesWilkinsLee& law, const GasState& g) {
  const double volume = law.density / g.density;
  return (g.pressure - law.pressure(volume, 0.)) * volume / law.omega;
}

TEST(TaylorWave, FiguresOfPetn1260) {
  const TaylorWave wave(petn_1260());
  constexpr double table[][3] = {{1, 13.9955, 1702.6},  // x/(D t), GPa, m/s
                                 {.9, 11.3723, 1361.07},
                                 {.8, 9.1752, 1030.45},
                                 {.7, 7.3369, 707.15},
                                 {.6, 5.7973, 386.44}};
  for (const auto& [x, pressure, velocity] : table) {
    const GasState g = wave.at(x);
    EXPECT_NEAR(g.pressure, pressure * 1e9, 5e4) << x;
    EXPECT_NEAR(g.velocity, velocity, x == 1 ? .05 : .005) << x;
  }
  EXPECT_NEAR(wave.rest(), .48134, 5e-6);
  EXPECT_NEAR(wave.at(.48).pressure, 4.2836e9, 5e4);
  EXPECT_NEAR(wave.isentrope_constant(), 1.26612e9, 5e3);
  EXPECT_NEAR(wave.front().velocity, 6523.84, 5e-3);
}

TEST(TaylorWave, RestsBehindAndWaitsAhead) {
  const TaylorWave wave(petn_1260());
  EXPECT_EQ(wave.at(0).velocity, 0);
  EXPECT_EQ(wave.at(0).pressure, wave.at(.48).pressure);
  EXPECT_EQ(wave.at(.45).velocity, 0);
  EXPECT_NEAR(wave.at(wave.rest() + 1e-7).velocity, 0, 1e-2);
  EXPECT_NEAR(wave.at(wave.rest() + 1e-7).pressure, wave.at(0).pressure, 1e-6 * wave.at(0).pressure);
  EXPECT_EQ(wave.at(1.01).pressure, 0);
  EXPECT_EQ(wave.at(1.01).velocity, 0);
  EXPECT_EQ(wave.at(1.01).density, 1260);
  EXPECT_THROW(wave.at(-.1), std::invalid_argument);
}

/// The law's own sound speed at the energy of the state: u + c = x/t all along the fan.
TEST(TaylorWave, TravelsAlongTheCharacteristics) {
  for (const JonesWilkinsLee& law : {petn_1260(), tnt}) {
    const TaylorWave wave(law);
    for (const double x : {1., .95, .85, .75, .65, .55}) {
      const GasState g = wave.at(x);
      const double volume = law.density / g.density;
      const double c = std::sqrt(law.bulk_modulus(volume, energy(law, g)) / g.density);
      EXPECT_NEAR((g.velocity + c) / wave.front().velocity, x, 1e-11);
    }
  }
}

/// Per time and area: the mass swept, the wall's impulse and the chemical energy, each over its integral.
TEST(TaylorWave, ConservesMassMomentumAndEnergy) {
  constexpr int cells = 4000;
  for (const JonesWilkinsLee& law : {petn_1260(), tnt}) {
    const TaylorWave wave(law);
    const double D = wave.front().velocity, rest = wave.rest(), width = (1 - rest) / cells;
    const GasState still = wave.at(0);
    double mass = rest * still.density, momentum = 0, total = rest * energy(law, still) / law.density * still.density;
    for (int i = 0; i < cells; ++i) {
      const GasState g = wave.at(rest + (i + .5) * width);
      mass += width * g.density;
      momentum += width * g.density * g.velocity;
      total += width * g.density * (energy(law, g) / law.density + .5 * g.velocity * g.velocity);
    }
    EXPECT_NEAR(mass / law.density, 1, 1e-7);
    EXPECT_NEAR(momentum * D / still.pressure, 1, 1e-7);
    EXPECT_NEAR(total / law.initial_energy, 1, 1e-7);
  }
}

TEST(TaylorWave, RefusesConstantsThatDoNotDetonate) {
  EXPECT_THROW(TaylorWave{JonesWilkinsLee{}}, std::invalid_argument);
  JonesWilkinsLee broken = tnt;
  broken.omega = NAN;
  EXPECT_THROW(TaylorWave{broken}, std::invalid_argument);
  broken.omega = -2;
  EXPECT_THROW(TaylorWave{broken}, std::invalid_argument);
}
}  // namespace
