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
/// That of shared masses.
template <class Body>
class Shared {
 public:
  using S = typename Body::SpaceType;
  Shared(Body& body, Grid<S>& grid) : grid_(grid) {
    locate(body, grid_, order_);
    calm_.find(body, order_, grid_);
  }
  bool serves() const { return calm_.serves(); }
  /// What is found for particles on their way.
  double on_the_way(Body& body) const {
    GridStiffness<double> all;
    for (std::size_t c = 0; c < chunk_count(body); ++c) all.raise(calm_.of_chunk(c));
    return inverse_square(all);
  }
  /// Of particles where they stand.
  double now(const Body& body) const {
    SharedMass<Body> shares;
    shares.share(body, order_, grid_);
    GridStiffness<double> all;
    for (std::size_t p = 0; p < body.size(); ++p) all.raise(shares.stiffness(body, p, grid_));
    return inverse_square(all);
  }

 private:
  Grid<S>& grid_;
  ParticleOrder order_;
  CalmStiffness<Body> calm_;
};
/// That of the particles' own shares, which is kept chunk by chunk.
template <class Body>
class Own {
 public:
  using S = typename Body::SpaceType;
  Own(Body& body, Grid<S>& grid) : grid_(grid) {
    kept_.resize(chunk_count(body));
    for (std::size_t c = 0; c < chunk_count(body); ++c) kept_.note(body, c, 0, grid);
  }
  bool serves() const { return true; }
  double on_the_way(Body& body) {
    const ChunkList chunks(body.size());
    GridStiffness<double> all;
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      EXPECT_TRUE(kept_.worthwhile(c));
      all.raise(kept_.of(body, chunks.first(c), chunks.count(c), grid_));
      EXPECT_TRUE(kept_.knows(c));
    }
    return inverse_square(all);
  }
  double now(const Body& body) const {
    GridStiffness<double> all;
    for (std::size_t p = 0; p < body.size(); ++p)
      all.raise(grid_stiffness<S>(make_stencil(body, p, grid_), body.x(0)[p], 1., OwnShare{}));
    return inverse_square(all);
  }

 private:
  Grid<S>& grid_;
  KeptStiffness<Body> kept_;
};

/// How much more than what was found for particles on their way random motion makes of 1/dt^2, at most, in random
/// fills; and how much more than what stood where they were.
struct Growth {
  double on_the_way = 0, of_place = 0;
  int steep = 0;  ///< fills, of 200, that are not for it
};
template <template <class> class Stiffness, class Shape, class S>
Growth growth() {
  Growth growth;
  Random random{1};
  std::uniform_real_distribution<> motion(-1, 1);
  for (int k = 0; k < 200; ++k) {
    auto [body, grid] = fill_grid<Shape, S>(random_fill(S::dimension, 30, random), random);
    Stiffness<std::remove_cvref_t<decltype(body)>> stiffness(body, grid);
    if (!stiffness.serves()) {
      ++growth.steep;
      continue;
    }
    const double found = stiffness.on_the_way(body), stood = stiffness.now(body);
    for (int trial = 0; trial < 10; ++trial) {
      auto moved = body;
      for (int d = 0; d < S::dimension; ++d)
        for (std::size_t p = 0; p < body.size(); ++p)
          moved.x(d)[p] += std::min(body.particle_size(p), grid.cell()) / 25 * motion(random);
      const double now = stiffness.now(moved);
      growth.on_the_way = std::max(growth.on_the_way, now / found);
      growth.of_place = std::max(growth.of_place, now / stood);
    }
  }
  return growth;
}
template <class Shape, class S>
void expect_good_within_reach(double shared_of_place, double own_of_place) {
  const Growth shared = growth<Shared, Shape, S>(), own = growth<Own, Shape, S>();
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

/// Of a block that moves as a whole by a cell: the steps that it takes over those of the plain form, the least and the
/// largest.
struct Range {
  double least = 1, largest = 0;
};
template <class Shape>
Range over_plain(double speed) {
  Random random{1};
  auto solver = fill_solver<Shape, Musl, PlaneStrain<>>(
      {.count = {6, 6, 1}, .offset = {.1, .1, 0}, .margin = {3, 3, 0}, .poisson = .2}, random);
  auto& body = solver.body();
  for (std::size_t p = 0; p < body.size(); ++p) body.v(0)[p] = speed;
  Range range;
  while (speed * solver.time < 1) {
    const double plain = stable_step(body, ChunkList(body.size()), solver.grid);
    const double ratio = solver.step() / (solver.safety * plain);
    range.least = std::min(range.least, ratio), range.largest = std::max(range.largest, ratio);
  }
  return range;
}
// What is kept of particles that come a 25th of their size in some fifty steps is found anew in time; where they come
// as far in one, it is not kept.
TEST(KeptStep, FollowsTheParticles) {
  const auto expect = [](const Range& slow, const Range& fast) {
    EXPECT_GT(slow.least, .97);
    EXPECT_LT(slow.least, 1 - 1e-5) << "looked at in every step";
    EXPECT_LT(slow.largest, 1.02);
    EXPECT_NEAR(fast.least, 1, 1e-12);
    EXPECT_NEAR(fast.largest, 1, 1e-12);
  };
  expect(over_plain<Ugimp>(1e-3), over_plain<Ugimp>(1e-1));
  expect(over_plain<QuadraticBspline>(1e-3), over_plain<QuadraticBspline>(1e-1));
  expect(over_plain<CubicBspline>(1e-3), over_plain<CubicBspline>(1e-1));
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
