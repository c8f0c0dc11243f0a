// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/method.hpp>

// A stiff block of four cells that turns twice, freely.
namespace {

using namespace mpm::atlas;

/// Share of the two turns that it has not turned.
double lost(const char* shape, const char* integrator) {
  double last = -1;
  find_method("2-D", shape, integrator).modes.at("turn")(true, [&](double, double share) { last = share; });
  return last;
}

// The remap keeps linear momentum, but of angular momentum it passes on what the nodes can see of each particle.
TEST(FreeTurn, FlipSlowsDownAndPicStops) {
  EXPECT_NEAR(lost("Ugimp", "USL"), .56, .04);
  EXPECT_NEAR(lost("Ugimp", "MUSL"), .78, .05);
  EXPECT_NEAR(lost("CpdiQuad", "USL"), .53, .04);
  EXPECT_GT(lost("Ugimp", "USL PIC"), .98);
  EXPECT_GT(lost("Ugimp", "FMPM(2)"), .98);
}
// What APIC loses is lost in the first step, when no particle knows yet how velocities vary around it.
TEST(FreeTurn, ApicGoesOn) {
  EXPECT_NEAR(lost("Ugimp", "APIC"), .135, .02);
  EXPECT_NEAR(lost("CpdiQuad", "APIC"), .162, .02);
}

}  // namespace
