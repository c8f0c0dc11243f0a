// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/modes/relaxed_bar.hpp>

// When a relaxation stops: a bar held at one end and pulled at the other, from no stress at all.
namespace {

using namespace mpm;
using atlas::RelaxedBar;
using atlas::Rest;

TEST(Relaxation, KineticEnergyAloneFallsWithTheWrongDamping) {
  const auto error = [](double share) { return RelaxedBar<Cpgimp, Damping::fixed>(share).when_slow().error; };
  EXPECT_GT(error(.1), .05);  // at a turning point
  EXPECT_LT(error(.1), .2);
  EXPECT_LT(error(10), -.25);  // while it creeps
  EXPECT_GT(error(10), -.5);
  EXPECT_LT(std::abs(error(1)), .05);
  EXPECT_LT(std::abs(RelaxedBar<Cpgimp, Damping::adaptive>().when_slow().error), .05);
}
// Force and motion together stand under any damping; the adaptive one is as fast as if it knew the frequency.
TEST(Relaxation, ForceAndMotionTogetherStand) {
  const Rest adaptive = RelaxedBar<Cpgimp, Damping::adaptive>().at_rest(),
             critical = RelaxedBar<Cpgimp, Damping::fixed>(1).at_rest();
  EXPECT_LT(std::abs(adaptive.error), .003);
  EXPECT_LT(std::abs(critical.error), .003);
  EXPECT_LT(double(adaptive.steps), 1.3 * double(critical.steps));
  for (const double share : {.1, 10.}) {
    const Rest wrong = RelaxedBar<Cpgimp, Damping::fixed>(share).at_rest();
    EXPECT_LT(std::abs(wrong.error), .003) << share;
    EXPECT_GT(double(wrong.steps), 5 * double(adaptive.steps)) << share;
  }
}

}  // namespace
