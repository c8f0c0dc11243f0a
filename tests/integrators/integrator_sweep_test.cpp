// SPDX-License-Identifier: MIT
#include "scene.hpp"

// What every integrator must obey with every shape, in every space.
namespace mpm::integrator_laws {
namespace {

template <class T>
class IntegratorSweep : public ::testing::Test {
 public:
  static constexpr int last_axis = T::S::dimension - 1;
  static auto solver(int length) { return block<typename T::Shape, typename T::IntegratorType, typename T::S>(length); }
};
TYPED_TEST_SUITE(IntegratorSweep, Combinations);

TYPED_TEST(IntegratorSweep, ConservesMomentum) {
  using Vec = Vector<typename TypeParam::S>;
  for (const double flip : {1.0, 0.7, 0.0}) {
    auto solver = this->solver(9);
    solver.integrator.flip = flip;
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
      EXPECT_LT(std::abs(change[d]), 2e-15 * scale);
  }
}

TYPED_TEST(IntegratorSweep, ATranslationIsRigid) {
  auto solver = this->solver(30);
  auto& body = solver.body();
  constexpr int axis = TestFixture::last_axis;
  const double v = sound_speed(), start = body.position(0)[axis], size = double(body.size());
  double first_mean = 0, mean = 0;
  for (std::size_t p = 0; p < body.size(); ++p) body.v(axis)[p] = v, first_mean += body.x(axis)[p] / size;
  while (solver.time * v < 20 * cell && solver.steps < 2000) solver.step(0.21 * cell / v);
  EXPECT_GE(solver.time * v, 5 * cell);  // past five cells, so past a block
  for (std::size_t p = 0; p < body.size(); ++p) {
    mean += body.x(axis)[p] / size;
    EXPECT_NEAR(body.v(axis)[p], v, 1e-11 * v);
    EXPECT_LT(equivalent_stress(body.stress(p)) + std::abs(trace(body.stress(p))), 1e-10 * young);
  }
  EXPECT_NEAR(mean - first_mean, v * solver.time, 1e-11);
  EXPECT_NE(start, body.position(0)[axis]);
}

/// A blend of FLIP and PIC keeps the mean field and takes out of the checkerboard what the grid cannot see.
TYPED_TEST(IntegratorSweep, PicRemovesWhatTheGridCannotSee) {
  const auto after = [&](double flip) {
    auto solver = this->solver(9);
    solver.integrator.flip = flip;
    auto& body = solver.body();
    // Two particles a cell with opposite velocities: their momentum at every inner node vanishes.
    for (std::size_t p = 0; p < body.size(); ++p) {
      const double x = (body.position(p)[0] - solver.grid.origin()[0]) / (cell / 2);
      body.v(0)[p] = int(std::floor(x)) % 2 ? 1 : -1;
    }
    const double start = kinetic_energy(body);
    solver.step(1e-9);
    return kinetic_energy(body) / start;
  };
  const double pic = after(0), half = after(0.5), flip = after(1);
  EXPECT_NEAR(flip, 1, 1e-6);
  EXPECT_LT(pic, 0.2);
  EXPECT_NEAR(half, (1 + 3 * 0) / 4.0, 0.15);
}

}  // namespace
}  // namespace mpm::integrator_laws
