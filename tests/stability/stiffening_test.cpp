// SPDX-License-Identifier: MIT
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
#include <gtest/gtest.h>
#include <random>

// Granite at 14 GPa: its equation of state makes sound there five times as fast as at rest.
namespace {

using namespace mpm;
using S = Uniaxial<>;
constexpr double pressure = 14e9;

double sound_speed(const JohnsonHolmquist2& rock, double J) {
  auto state = rock.initial<double>();
  return std::sqrt(rock.tangent(state, J).longitudinal * J / rock.density);
}

/// Largest particle velocity in 400 steps, in that of random velocities at the start. The step is .5 h/c with c the
/// sound speed at rest, or the solver's own.
double growth(bool constant_speed) {
  constexpr int cells = 20;
  constexpr double v = 1e-3;
  JohnsonHolmquist2 rock = granite_paper();
  const double J = rock.relative_volume(pressure), at_rest = sound_speed(rock, 1);
  Body<Ugimp, JohnsonHolmquist2, S> bar{"rock", {{.25}}, rock};
  std::mt19937_64 engine{5};
  std::uniform_real_distribution<> speed(-v, v);
  for (int p = 0; p < 2 * cells; ++p) {
    bar.add(Vector<S>{.5 * (p + .5)}, .5, Vector<S>{speed(engine)}, J);
    bar.store(std::size_t(p), {.stress = SymmetricTensor<double>::spherical(-pressure)});
  }
  Solver<Ugimp, JohnsonHolmquist2, Musl, S> solver{Grid<S>{Vector<S>{0.0}, 1, {cells}}, std::move(bar)};
  for (const int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};
  if (constant_speed) solver.safety = 1e9;
  double largest = 0;
  for (int k = 0; k < 400 && largest < 1e4 * v; ++k) {
    solver.step(constant_speed ? .5 / at_rest : 1);
    for (std::size_t p = 0; p < solver.body().size(); ++p) largest = std::max(largest, std::abs(solver.body().v(0)[p]));
  }
  return largest / v;
}

TEST(Stiffening, AConstantSoundSpeedIsUnsafe) {
  const JohnsonHolmquist2 rock = granite_paper();
  EXPECT_NEAR(sound_speed(rock, 1), 4544, 5);
  EXPECT_NEAR(sound_speed(rock, rock.relative_volume(pressure)), 21e3, 1e3);
  EXPECT_GT(growth(true), 1e4);
}
TEST(Stiffening, TheTangentStands) {
  EXPECT_LT(growth(false), 3);
}

}  // namespace
