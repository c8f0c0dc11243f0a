// SPDX-License-Identifier: MIT
#pragma once
#include "scene.hpp"

// What every integrator must obey with every shape, in every space: one file a space instantiates it, for the
// compiler's sake.
namespace mpm::integrator_laws {
namespace {

template <class T>
class IntegratorSweep : public ::testing::Test {
 public:
  static constexpr int last_axis = T::S::dimension - 1;
  static auto solver(int length) { return block<typename T::Shape, typename T::IntegratorType, typename T::S>(length); }
};
TYPED_TEST_SUITE_P(IntegratorSweep);

TYPED_TEST_P(IntegratorSweep, ConservesMomentum) {
  using Vec = Vector<typename TypeParam::S>;
  constexpr bool blends = requires(typename TypeParam::IntegratorType i) {
    i.flip;
  };
  for (const double flip : blends ? std::vector{1.0, 0.7, 0.0} : std::vector{1.0}) {
    auto solver = this->solver(9);
    if constexpr (blends) solver.integrator.flip = flip;
    auto& body = solver.body();
    std::mt19937_64 engine{3};
    std::uniform_real_distribution<> speed(-1, 1);
    double scale = 0;
    for (std::size_t p = 0; p < body.size(); ++p)
      for (int d = 0; d < Vec::RowsAtCompileTime; ++d) {
        body.v(d)[p] = speed(engine);
        scale += body.mass()[p] * std::abs(body.v(d)[p]);
      }
    const Vec start = momentum(body);
    for (int i = 0; i < 25; ++i) solver.step();
    const Vec change = momentum(body) - start;
    EXPECT_GT(equivalent_stress(body.stress(0)), 1e-7 * young);  // forces have acted
    for (int d = TypeParam::S::hoop ? 1 : 0; d < Vec::RowsAtCompileTime; ++d)
      EXPECT_LT(std::abs(change[d]),
                1e-14 * scale);  // FMPM: 6e-15, weights in modes and of stencils differ in last bits
  }
}

TYPED_TEST_P(IntegratorSweep, ATranslationIsRigid) {
  constexpr int axis = TestFixture::last_axis;
  constexpr int start = axis == 0 ? 60 : 0;  // in cells; on a line a block is 64 long
  auto solver = this->solver(start + 30);
  auto& body = solver.body();
  const double v = sound_speed(), size = double(body.size());
  double first_mean = 0, mean = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    body.x(axis)[p] += start * cell, body.v(axis)[p] = v;
    first_mean += body.x(axis)[p] / size;
  }
  while (solver.time * v < 20 * cell && solver.steps < 2000) solver.step(0.21 * cell / v);
  EXPECT_GE(solver.time * v, 5 * cell);  // past five cells, so past a block
  for (std::size_t p = 0; p < body.size(); ++p) {
    mean += body.x(axis)[p] / size;
    EXPECT_NEAR(body.v(axis)[p], v, 1e-11 * v);
    EXPECT_LT(equivalent_stress(body.stress(p)) + std::abs(trace(body.stress(p))), 1e-10 * young);
  }
  EXPECT_NEAR(mean - first_mean, v * solver.time, 1e-11);
}

/// Under a body force alone nothing is strained, the nodes' velocities are exact, and symplectic Euler falls as far as
/// n steps of the new velocity, g dt^2 n (n + 1)/2: the work of the weight is the kinetic energy and 1/n of it.
TYPED_TEST_P(IntegratorSweep, FreeFallIsExact) {
  auto solver = this->solver(9);
  auto& body = solver.body();
  constexpr int axis = TestFixture::last_axis, n = 30;
  const double g = 9.81, dt = 0.1 * cell / sound_speed();
  const auto middle = [&] {
    double sum = 0;
    for (std::size_t p = 0; p < body.size(); ++p) sum += body.mass()[p] * body.x(axis)[p];
    return sum;
  };
  const double start = middle();
  solver.body_force[axis] = -g;
  for (int i = 0; i < n; ++i) ASSERT_EQ(solver.step(dt), dt);
  for (std::size_t p = 0; p < body.size(); ++p) EXPECT_NEAR(body.v(axis)[p], -g * n * dt, 1e-12 * g * n * dt);
  const double work = g * (start - middle()), kinetic = kinetic_energy(body);
  EXPECT_NEAR(work / kinetic, 1 + 1.0 / n, 1e-6);
  EXPECT_LT(std::abs(body.stress_work), 1e-12 * kinetic);
  EXPECT_EQ(solver.boundary.work(), 0);
}

/// A blend of FLIP and PIC keeps the mean field and takes out of the checkerboard what the grid cannot see; what keeps
/// the particles' own velocities keeps all of it.
TYPED_TEST_P(IntegratorSweep, PicRemovesWhatTheGridCannotSee) {
  constexpr bool blends = requires(typename TypeParam::IntegratorType i) {
    i.flip;
  };
  const auto after = [&](double flip) {
    auto solver = this->solver(9);
    if constexpr (blends) solver.integrator.flip = flip;
    auto& body = solver.body();
    // Two particles a cell with opposite velocities: their momentum at every inner node vanishes.
    for (std::size_t p = 0; p < body.size(); ++p) {
      const double x = (body.position(p)[0] - solver.grid.origin()[0]) / (cell / 2);
      body.v(0)[p] = int(std::floor(x)) % 2 ? 1 : -1;
    }
    const double start = kinetic_energy(body);
    solver.step(1e-9);
    const double kept = kinetic_energy(body) / start;
    return std::pair{std::move(body), kept};
  };
  const auto [pic, pic_energy] = after(0);
  const auto [blend, blend_energy] = after(0.3);
  const auto [flip, flip_energy] = after(1);
  const bool keeps = !blends && typename TypeParam::IntegratorType{}.particle_velocity(1.0, 0.0, 0.0) == 1;
  if (keeps) {
    EXPECT_NEAR(pic_energy, 1, 1e-6);
  } else {
    EXPECT_LT(pic_energy, 0.2);
  }
  if (!blends) return;
  EXPECT_NEAR(flip_energy, 1, 1e-6);
  for (std::size_t p = 0; p < flip.size(); ++p)
    EXPECT_NEAR(blend.v(0)[p], 0.3 * flip.v(0)[p] + 0.7 * pic.v(0)[p], 1e-14);
}

REGISTER_TYPED_TEST_SUITE_P(IntegratorSweep, ConservesMomentum, ATranslationIsRigid, FreeFallIsExact,
                            PicRemovesWhatTheGridCannotSee);

}  // namespace
}  // namespace mpm::integrator_laws
