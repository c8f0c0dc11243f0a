// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/modes/struck_bar.hpp>

// A bar fixed at one end, one half of it struck with a step velocity, ten periods.
namespace {

using namespace mpm;

/// Change of kinetic energy and stress work, relative to the start.
template <class Integrator>
double energy_change(const Integrator& integrator, int cells) {
  return atlas::struck_bar<Cpdi>(integrator, cells, [](double, double) {});
}

// Not a matter of resolution alone: what the remap smooths of a front that all grid modes make up is lost.
TEST(StruckBar, LastAndPicLoseEnergy) {
  EXPECT_NEAR(energy_change(Usl{}, 10), -.165, .012);
  EXPECT_NEAR(energy_change(Usl{}, 20), -.088, .01);
  EXPECT_NEAR(energy_change(Usl{}, 40), -.054, .006);
  EXPECT_NEAR(energy_change(Musl{.flip = 0}, 10), -.992, .005);
  EXPECT_NEAR(energy_change(Musl{.flip = 0}, 20), -.92, .02);
}
TEST(StruckBar, ModifiedLastAndFirstKeepIt) {
  EXPECT_NEAR(energy_change(Musl{}, 10), .013, .005);
  EXPECT_NEAR(energy_change(Usf{}, 10), -.0055, .003);
  for (const int cells : {20, 40}) {
    EXPECT_NEAR(energy_change(Musl{}, cells), -.0009, .0008) << cells;
    EXPECT_NEAR(energy_change(Usf{}, cells), .0037, .0025) << cells;
  }
}

}  // namespace
