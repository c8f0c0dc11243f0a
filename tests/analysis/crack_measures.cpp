// SPDX-License-Identifier: MIT
#include <mpm/analysis/crack_rose.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace {
using namespace mpm::analysis;

struct Rock {
  std::vector<double> x, y, area, damage, crushing;

  void add(double r, double degrees, double size, double d, double crush = 0) {
    const double theta = degrees * std::numbers::pi / 180;
    x.push_back(r * std::cos(theta)), y.push_back(r * std::sin(theta));
    area.push_back(size), damage.push_back(d), crushing.push_back(crush);
  }
  CrackMeasures measures(const CrackCount& count) const {
    return crack_measures({x, y, area, damage, crushing}, count);
  }
  std::vector<double> rose(const CrackCount& count, int sectors) const {
    return crack_rose({x, y, area, damage, crushing}, count, sectors);
  }
};

TEST(CrackMeasures, ReachIsThePercentileAndLongestTheMaximum) {
  Rock rock;
  for (int i = 1; i <= 1000; ++i) rock.add(0.001 * i, 45, 2e-6, 1);
  for (int i = 1; i <= 1000; ++i) rock.add(0.005 * i, 45, 2e-6, 0.5);  // at the threshold is not beyond it
  const CrackMeasures m = rock.measures({.threshold = 0.5, .ring_width = 0.01, .multiplicity = 4});
  EXPECT_NEAR(m.reach, 0.995, 1e-12);
  EXPECT_NEAR(m.longest, 1, 1e-12);
  EXPECT_NEAR(m.area, 4 * 1000 * 2e-6, 1e-15);
  EXPECT_EQ(m.along_x, 0);
  EXPECT_EQ(m.along_y, 0);
  EXPECT_EQ(m.crushed_radius, 0);
}

TEST(CrackMeasures, PercentileIsByArea) {
  Rock rock;
  for (int i = 1; i <= 99; ++i) rock.add(0.01 * i, 45, 1e-9, 1);
  rock.add(0.3, 45, 1, 1);
  EXPECT_NEAR(rock.measures({}).reach, 0.3, 1e-12);
}

TEST(CrackMeasures, AxesTakeThirtyDegreesEitherSide) {
  Rock rock;
  rock.add(1, 0, 1, 1);
  rock.add(3, 29, 1, 1);
  rock.add(4, 180 + 28, 1, 1);
  rock.add(9, 31, 1, 1);
  rock.add(10, 59, 1, 1);
  rock.add(5, 61, 1, 1);
  rock.add(6, -91, 1, 1);
  const CrackMeasures m = rock.measures({});
  EXPECT_NEAR(m.along_x, 4, 1e-12);
  EXPECT_NEAR(m.along_y, 6, 1e-12);
  EXPECT_NEAR(m.reach, 10, 1e-12);
}

TEST(CrackMeasures, CrushedRadiusIsWhereTheRingMeanFallsToAHalf) {
  Rock rock;  // rings of 0.1: none below 0.2, 0.8, (empty), 0.55 by area, 0.45 by area, then crushed again
  rock.add(0.25, 10, 1, 1, 0.8);
  rock.add(0.45, 10, 1.1, 1, 1);
  rock.add(0.45, 50, 0.9, 1, 0);
  rock.add(0.55, 10, 0.9, 1, 1);
  rock.add(0.55, 50, 1.1, 1, 0);
  rock.add(0.65, 50, 1, 1, 1);
  const CrackMeasures m = rock.measures({.ring_width = 0.1});
  EXPECT_NEAR(m.crushed_radius, 0.5, 1e-12);
}

TEST(CrackMeasures, CrushedAreaCountsCrushingAlone) {
  Rock rock;
  rock.add(1, 10, 2, 1, 0.4);
  rock.add(1, 20, 3, 1, 0.6);
  EXPECT_NEAR(rock.measures({.multiplicity = 4}).crushed_area, 12, 1e-12);
}

TEST(CrackRose, ReachesFarthestWhereTheCracksDo) {
  Rock rock;
  rock.add(1, 0, 1, 1);
  rock.add(2, 44, 1, 1);  // the sector about 0 ends at 45 degrees, that about 90 at 135
  rock.add(5, 46, 1, 1);
  rock.add(9, 90, 1, 0.5);  // at the threshold is not beyond it
  rock.add(3, -46, 1, 1);
  EXPECT_EQ(rock.rose({}, 4).size(), 4u);
  const double open[] = {2, 5, 0, 3}, mirrored[] = {2, 5, 2, 5};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(rock.rose({}, 4)[k], open[k], 1e-12) << k;
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(rock.rose({.multiplicity = 4}, 4)[k], mirrored[k], 1e-12) << k;
  EXPECT_THROW(rock.rose({}, 0), std::invalid_argument);
}

TEST(CrackMeasures, NothingDamagedIsZero) {
  for (const bool any : {false, true}) {
    Rock rock;
    if (any) rock.add(1, 0, 1, 0.2, 0.1);
    const CrackMeasures m = rock.measures({});
    EXPECT_EQ(m.reach, 0);
    EXPECT_EQ(m.along_x, 0);
    EXPECT_EQ(m.along_y, 0);
    EXPECT_EQ(m.longest, 0);
    EXPECT_EQ(m.area, 0);
    EXPECT_EQ(m.crushed_radius, 0);
  }
}

TEST(CrackMeasures, RefusesUnequalColumnsAndBadRings) {
  Rock rock;
  rock.add(1, 0, 1, 1);
  EXPECT_THROW(rock.measures({.ring_width = 0}), std::invalid_argument);
  rock.crushing.clear();
  EXPECT_THROW(rock.measures({}), std::invalid_argument);
}
}  // namespace
