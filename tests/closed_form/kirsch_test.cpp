// SPDX-License-Identifier: MIT
#include "holed_rock.hpp"
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

// Linear elastic rock relaxed under far-field stress, against Kirsch's solution.
namespace {

using namespace holed_rock;
using mpm::analysis::Kirsch;
using Relaxer = mpm::Solver<mpm::CpdiQuad, mpm::Hypoelastic, mpm::DynamicRelaxation<>>;

constexpr double vertical = -40e6;
enum class Start { exact, far_field };

/// Errors in per cent of the larger far-field stress.
struct Errors {
  double wall_0 = 0, wall_90 = 0;  ///< hoop stress on the wall at 0 and 90 degrees, signed
  double far = 0;                  ///< all in-plane components for r >= 3a, L2
  std::int64_t steps = 0;
};

Errors relaxed(double cells, double k, Start start, double tolerance) {
  const Kirsch kirsch{.horizontal = k * vertical, .vertical = vertical, .radius = a};
  const auto exact = [&](double x, double y) { return kirsch.stress(x, y); };
  const auto far = [&](double, double) { return mpm::analysis::PlanarStress{k * vertical, vertical, 0}; };
  const auto rock = mpm::granite_elastic();
  Relaxer solver(grid(20, cells), mpm::geometry::make_body("rock", block(20, cells).mesh(), rock));
  roll_on_axes(solver);
  // Kirsch's traction from either start: the far field's own would be that of a finite block.
  pull_outer_faces(solver, exact);
  if (start == Start::exact) set_stress(solver.body(), rock.poisson, exact);
  if (start == Start::far_field) set_stress(solver.body(), rock.poisson, far);

  Errors e;
  e.steps = mpm::relax(solver, {.tolerance = tolerance}).steps;
  const double unit = 0.01 * std::max(1.0, k) * std::abs(vertical);
  const auto wall = mpm::analysis::fit_wall(Samples(solver.body()), a, std::min(.5, 2 / cells) * a).hoop;
  e.wall_0 = (wall.mean + wall.cos2 - kirsch.polar_stress(a, 0).tt) / unit;
  e.wall_90 = (wall.mean - wall.cos2 - kirsch.polar_stress(a, std::numbers::pi / 2).tt) / unit;
  double sum = 0, area = 0;
  for (std::size_t p = 0; p < solver.body().size(); ++p) {
    const auto x = solver.body().position(p);
    if (x.norm() < 3 * a) continue;
    const auto s = solver.body().stress(p);
    const auto t = kirsch.stress(x[0], x[1]);
    const double V = solver.body().volume()[p];
    sum += V * (std::pow(s.xx - t.xx, 2) + std::pow(s.yy - t.yy, 2) + 2 * std::pow(s.xy - t.xy, 2));
    area += V;
  }
  e.far = std::sqrt(sum / area) / unit;
  return e;
}

double worst(const Errors& e) {
  return std::max(std::abs(e.wall_0), std::abs(e.wall_90));
}

class KirschRock : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(StressRatios, KirschRock, testing::Values(.25, 1, 3),
                         [](const auto& test) { return "k" + std::to_string(int(100 * test.param)); });

// Asked: 5 % at a/2, 2 % at a/4, 1 % at a/8, relaxed to 1e-6.
TEST_P(KirschRock, WallStressConvergesFromTheExactStart) {
  const Errors half = relaxed(2, GetParam(), Start::exact, 1e-7);
  const Errors quarter = relaxed(4, GetParam(), Start::exact, 1e-7);
  EXPECT_LT(worst(half), 2.5);
  EXPECT_LT(worst(quarter), 1);
  EXPECT_LE(quarter.steps, 300);
  const double order = std::log2(half.far / quarter.far);
  EXPECT_GT(order, 1.5);
  EXPECT_LT(order, 2.7);
  EXPECT_LT(worst(relaxed(8, GetParam(), Start::exact, 1e-6)), .3);
}

// The paper's 10 mm grid. Asked: 1 % for r >= 3 a.
TEST_P(KirschRock, FarRockHoldsOnThePapersGrid) {
  constexpr double cells = a / .01;
  EXPECT_LT(relaxed(cells, GetParam(), Start::exact, 1e-6).far, .02);
  EXPECT_LT(relaxed(cells, GetParam(), Start::far_field, 1e-6).far, .3);
}

// Nothing of the hole's stress is given here: the relaxation finds it.
TEST(KirschRock, IsFoundFromTheFarField) {
  const Errors e = relaxed(4, .25, Start::far_field, 1e-6);
  EXPECT_LT(worst(e), 1);
  EXPECT_LT(e.far, .2);
  EXPECT_LE(e.steps, 1200);
}

}  // namespace
