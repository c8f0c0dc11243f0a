// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/fill_solver.hpp>

// The step with shared masses, of bodies that keep their places.
namespace {

using namespace mpm;
using namespace mpm::atlas;

/// 1/dt^2 at c = h = 1 of the stiffness of the grid to all particles of a body, Poisson's ratio 1/4: lambda = G = 2/5.
template <class Scalar>
Scalar inverse_square(const GridStiffness<Scalar>& b) {
  return inverse_square_step(Scalar(.4), Scalar(.4), b);
}
/// Of particles where they stand.
template <class Body, class S>
double shared_now(const Body& body, const ParticleOrder& order, const Grid<S>& grid) {
  SharedMass<Body> shares;
  shares.share(body, order, grid);
  GridStiffness<double> all;
  for (std::size_t p = 0; p < body.size(); ++p) all.raise(shares.stiffness(body, p, grid));
  return inverse_square(all);
}
/// Of particles on their way.
template <class Body>
double while_calm(const CalmStiffness<Body>& calm, const Body& body) {
  GridStiffness<double> all;
  for (std::size_t c = 0; c < chunk_count(body); ++c) all.raise(calm.of_chunk(c));
  return inverse_square(all);
}

/// How much more than what was found for particles on their way random motion makes of 1/dt^2, at most, in random
/// fills; and how much more than what stood where they were.
struct Growth {
  double on_the_way = 0, of_place = 0;
  int steep = 0;  ///< fills, of 200, that are not for it
};
template <class Body, class S, class F>
void move_within_reach(const Body& body, const Grid<S>& grid, Random& random, const F& look) {
  std::uniform_real_distribution<> motion(-1, 1);
  for (int trial = 0; trial < 10; ++trial) {
    Body moved = body;
    for (int d = 0; d < S::dimension; ++d)
      for (std::size_t p = 0; p < body.size(); ++p)
        moved.x(d)[p] += std::min(body.particle_size(p), grid.cell()) / 25 * motion(random);
    look(moved);
  }
}
template <class Shape, class S>
Growth growth_of_shared() {
  Growth growth;
  Random random{1};
  for (int k = 0; k < 200; ++k) {
    auto [body, grid] = fill_grid<Shape, S>(random_fill(S::dimension, 30, random), random);
    ParticleOrder order;
    locate(body, grid, order);
    CalmStiffness<decltype(body)> calm;
    calm.find(body, order, grid);
    if (!calm.serves()) {
      ++growth.steep;
      continue;
    }
    const double found = while_calm(calm, body), stood = shared_now(body, order, grid);
    move_within_reach(body, grid, random, [&, &grid = grid](const auto& moved) {
      const double now = shared_now(moved, order, grid);
      growth.on_the_way = std::max(growth.on_the_way, now / found);
      growth.of_place = std::max(growth.of_place, now / stood);
    });
  }
  return growth;
}
/// The same of the particles' own shares, which are kept chunk by chunk.
template <class Shape, class S>
Growth growth_of_own() {
  Growth growth;
  Random random{1};
  for (int k = 0; k < 200; ++k) {
    auto [body, grid] = fill_grid<Shape, S>(random_fill(S::dimension, 30, random), random);
    const auto own = [&grid = grid](const auto& at) {
      GridStiffness<double> all;
      for (std::size_t p = 0; p < at.size(); ++p)
        all.raise(grid_stiffness<S>(make_stencil(at, p, grid), at.x(0)[p], 1., OwnShare{}));
      return inverse_square(all);
    };
    const ChunkList chunks(body.size());
    KeptStiffness<decltype(body)> kept;
    kept.resize(chunks.size());
    GridStiffness<double> all;
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      kept.note(body, c, 0, grid);
      EXPECT_TRUE(kept.worthwhile(c));
      all.raise(kept.of(body, chunks.first(c), chunks.count(c), grid));
      EXPECT_TRUE(kept.knows(c));
    }
    const double found = inverse_square(all), stood = own(body);
    move_within_reach(body, grid, random, [&](const auto& moved) {
      growth.on_the_way = std::max(growth.on_the_way, own(moved) / found);
      growth.of_place = std::max(growth.of_place, own(moved) / stood);
    });
  }
  return growth;
}
template <class Shape, class S>
void expect_good_within_reach(double shared_of_place, double own_of_place) {
  const Growth shared = growth_of_shared<Shape, S>(), own = growth_of_own<Shape, S>();
  EXPECT_LT(shared.on_the_way, 1.25);
  EXPECT_LT(own.on_the_way, 1.25);
  EXPECT_NEAR(shared.of_place, shared_of_place, .1);
  EXPECT_NEAR(own.of_place, own_of_place, .1);
  EXPECT_LE(shared.steep, 10);
}
// By 14 % at most, well within the safety of the step, which allows 1/.8^2 = 1.56; without the nodes that are about to
// be touched, boxes would be beyond.
TEST(StiffnessOnTheWay, IsGoodWhereverTheParticlesMayBe) {
  expect_good_within_reach<Ugimp, Uniaxial<>>(1.69, 1.10);
  expect_good_within_reach<Cpgimp, Uniaxial<>>(1.81, 2.07);
  expect_good_within_reach<QuadraticBspline, Uniaxial<>>(1.51, 1.06);
  expect_good_within_reach<CubicBspline, Uniaxial<>>(1.02, 1.06);
  expect_good_within_reach<Ugimp, PlaneStrain<>>(2.58, 1.17);
  expect_good_within_reach<QuadraticBspline, PlaneStrain<>>(1.25, 1.22);
  expect_good_within_reach<CubicBspline, PlaneStrain<>>(1.04, 1.06);
  expect_good_within_reach<Ugimp, Axisymmetric<>>(1.32, 1.17);
  expect_good_within_reach<Ugimp, Spatial<>>(1.48, 1.89);
}
// At a face a spline goes on as a hat, whose stiffness has no bound.
TEST(StiffnessOnTheWay, IsNotKeptBesideAFaceWithSplines) {
  for (const auto& [offset, keeps] : {std::pair{.01, false}, {.1, true}}) {
    Random random{1};
    auto [body, grid] = fill_grid<QuadraticBspline, PlaneStrain<>>({.count = {3, 3, 1}, .offset = {.3, .3, 0}}, random);
    body.x(1)[0] = offset;
    ParticleOrder order;
    locate(body, grid, order);
    KeptStiffness<decltype(body)> kept;
    CalmStiffness<decltype(body)> calm;
    kept.resize(1);
    kept.note(body, 0, 0, grid);
    calm.find(body, order, grid);
    EXPECT_EQ(kept.worthwhile(0), keeps);
    EXPECT_EQ(calm.serves(), keeps);
  }
}

// A particle about to leave the node behind it, which nothing else touches: 1/l comes or goes with it at once.
TEST(CalmStep, DoesNotServeWhereTheWayMakesTooMuchOfADifference) {
  Random random{1};
  const Fill fill{
      .per_edge = 4, .count = {4, 1, 1}, .offset = {.893, 0, 0}, .margin = {2, 0, 0}, .stretch = {1.777, 1, 1}};
  auto [body, grid] = fill_grid<Ugimp, Uniaxial<>>(fill, random);
  ParticleOrder order;
  locate(body, grid, order);
  CalmStiffness<decltype(body)> calm;
  calm.find(body, order, grid);
  EXPECT_FALSE(calm.serves());
}

/// Steps of a block that moves as a whole at so many c, at safety 1, in h/c; the grid's nodes are a unit apart.
std::vector<double> steps_of_block(double speed, int steps) {
  Random random{1};
  auto solver = fill_solver<Ugimp, Usl, PlaneStrain<>>(
      {.count = {6, 6, 1}, .offset = {.1, .1, 0}, .margin = {3, 3, 0}, .poisson = .2}, random);
  for (std::size_t p = 0; p < solver.body().size(); ++p) solver.body().v(0)[p] = speed;
  std::vector<double> dt;
  for (int k = 0; k < steps; ++k) dt.push_back(solver.step() / solver.safety);
  return dt;
}
// A body at rest takes the longer step as soon as it has been calm for long enough.
TEST(CalmStep, ComesWhenTheBodyHasBeenCalm) {
  const auto dt = steps_of_block(0, 600);
  const auto longer = std::find_if(dt.begin(), dt.end(), [&](double step) { return step > dt[0]; });
  EXPECT_EQ(longer - dt.begin(), 512);
  EXPECT_NEAR(dt.back() / dt[0], 1.115, .01);
}
// A body on its way has it found anew before it is beyond reach, a 25th of half a cell: from .1 to .15 its edge passes
// no node.
TEST(CalmStep, IsFoundAnewOnTheWay) {
  const double speed = 5e-5;
  const auto dt = steps_of_block(speed, 6000);
  double moved = 0;
  int changes = 0;
  for (std::size_t k = 513; k < dt.size(); ++k) {
    EXPECT_GT(dt[k], 1.1 * dt[0]) << k;
    changes += dt[k] != dt[k - 1];
    moved += dt[k] * .8 * speed;
  }
  EXPECT_NEAR(changes, moved / .02, 1);
}
// What is on its way faster keeps Irons' step.
TEST(CalmStep, IsNotForWhatMoves) {
  const auto dt = steps_of_block(1e-3, 600);
  EXPECT_LT(*std::max_element(dt.begin() + 513, dt.end()), 1.05 * dt[0]);
}

}  // namespace
