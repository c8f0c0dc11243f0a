// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/method.hpp>
#include <Eigen/Eigenvalues>

// A run of a random state grows as the largest eigenvalue of the step's matrix says.
namespace {

using namespace mpm::atlas;

void expect_alike(const char* space, const char* shape, const char* integrator, double dt) {
  Random random{1};
  const Fill fill{.count = {4, 4, 1}, .offset = {.3, .6, 0}, .margin = {2, 2, 2}, .poisson = .2};
  const auto step = find_method(space, shape, integrator).at_rest(fill, random);
  const double radius = step->matrix(dt).eigenvalues().cwiseAbs().maxCoeff();
  // What grows fast is soon out of range, before the second largest eigenvalue is out of the way.
  EXPECT_NEAR(step->growth_rate(dt, 2000), radius, (radius < 1.1 ? .003 : .02) * radius)
      << space << ' ' << shape << ' ' << integrator << " at " << dt;
}
TEST(RestingStep, GrowsAsItsLargestEigenvalue) {
  for (const char* integrator : {"USF", "USL", "MUSL", "FMPM(4)", "full-mass FLIP(2)", "MUSL FLIP .99", "USL PIC"})
    for (const double dt : {.3, 1.2, 2.4}) {
      expect_alike("1-D", "Ugimp", integrator, dt);
      expect_alike("2-D", "CpdiQuad", integrator, dt);
    }
}

}  // namespace
