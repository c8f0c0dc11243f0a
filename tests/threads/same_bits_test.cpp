// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mpm/analysis/state_hash.hpp>
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
#include <algorithm>
#include <cmath>
#ifdef _OPENMP
#include <omp.h>
#endif

// Same binary, same input, any number of threads: the same bits.
namespace {

using namespace mpm;

void use_threads([[maybe_unused]] int count) {
#ifdef _OPENMP
  omp_set_dynamic(0);
  omp_set_num_threads(count);
#endif
}

/// Sets a scene up with `make` and carries it through `run(solver)` on 1, 2, 3 and 8 threads.
template <class Make, class Run>
void expect_same_bits(const Make& make, const Run& run) {
  std::uint64_t first = 0;
  for (const int threads : {1, 2, 3, 8}) {
    use_threads(threads);
    auto solver = make();
    const auto start = state_hash(solver);
    run(solver);
    const auto hash = state_hash(solver);
    EXPECT_NE(hash, start);
    if (threads == 1) first = hash;
    EXPECT_EQ(hash, first) << threads << " threads";
  }
}
constexpr auto steps = [](int count) {
  return [=](auto& solver) {
    for (int i = 0; i < count; ++i) solver.step();
  };
};

constexpr auto disc = [](double x, double y, double radius) {
  return [=](const auto& at) { return std::hypot(at[0] - x, at[1] - y) < radius; };
};

/// The scene and the times of examples/first.cpp.
TEST(SameBits, CollidingDiscs) {
  const auto make = [] {
    Body<Cpgimp, NeoHookean> discs{"discs", {}, {.density = 1000, .young = 1000, .poisson = .3}};
    fill(discs, {0, 0}, {1, 1}, .025, disc(.3, .3, .2), {.1, .1});
    fill(discs, {0, 0}, {1, 1}, .025, disc(.7, .7, .2), {-.1, -.1});
    return Solver<Cpgimp, NeoHookean, Musl>{Grid<PlaneStrain<>>{{0, 0}, .05, {20, 20}}, std::move(discs)};
  };
  expect_same_bits(make, [](auto& solver) {
    for (const double time : {0., .5, 1., 1.5, 2., 2.5}) solver.run(time);
  });
}

/// A charge that bursts a block of rock: particles that ride corners and particles that wander between blocks of the
/// grid, three laws with histories, rollers and a quiet face.
TEST(SameBits, BlastOfMixedBodies) {
  using Rock = WithTensileLaw<JohnsonHolmquist2>;
  using Shapes = PerBody<CpdiQuad, Ugimp, Ugimp>;
  using Laws = PerBody<Rock, JonesWilkinsLee, PolynomialEos>;
  const auto make = [] {
    const double h = .01;
    Body<CpdiQuad, Rock> rock{"rock", {}, granite_paper()};
    fill(rock, {0, 0}, {.4, .4}, h / 2, [](const auto& x) { return std::hypot(x[0] - .2, x[1] - .2) > .04; });
    Body<Ugimp, JonesWilkinsLee> charge{"charge", {}, petn_1260()};
    fill(charge, {0, 0}, {.4, .4}, h / 10, disc(.2, .2, .03));
    Body<Ugimp, PolynomialEos> air{"air", {}, mpm::air()};
    fill(air, {0, 0}, {.4, .4}, h / 10,
         [](const auto& x) { return std::abs(std::hypot(x[0] - .2, x[1] - .2) - .035) < .005; });
    EXPECT_TRUE(worth_threads(rock.size()) && worth_threads(charge.size()) && worth_threads(air.size()));
    Solver<Shapes, Laws, Musl> solver{Grid<PlaneStrain<>>{{0, 0}, h, {40, 40}}, std::move(rock), std::move(charge),
                                      std::move(air)};
    solver.boundary.face(0, 0) = Rollers<PlaneStrain<>>{};
    const auto quiet =
        Quiet<PlaneStrain<>>::from(2660, granite_elastic().tangent(granite_elastic().initial<double>(), 1.));
    solver.boundary.face(1, 1) = quiet;
    solver.hold_quiet_faces();
    return solver;
  };
  expect_same_bits(make, steps(120));
}

/// A block that trembles: once it has been calm for long enough, its particles share the masses of their nodes.
TEST(SameBits, CalmBlock) {
  const auto make = [] {
    Body<Ugimp, Hypoelastic> block{"block", {}, {.density = 1, .young = 1, .poisson = .25}};
    fill(block, {2.01, 2.01}, {26.01, 26.01}, .5);
    EXPECT_TRUE(worth_threads(block.size()));
    for (std::size_t p = 0; p < block.size(); ++p) block.v(0)[p] = 1e-7 * std::sin(double(p));
    return Solver<Ugimp, Hypoelastic, Usl>{Grid<PlaneStrain<>>{{0, 0}, 1, {28, 28}}, std::move(block)};
  };
  expect_same_bits(make, [](auto& solver) {
    const double first = solver.step();
    for (int k = 0; k < 520; ++k) solver.step();
    EXPECT_GT(solver.step(), 1.05 * first);
  });
}

/// A bar that flies from block to block while waves run along it, too fast for anything to be kept of its step.
TEST(SameBits, WavesAlongAFlyingBar) {
  using Line = Uniaxial<>;
  const auto make = [] {
    Body<QuadraticBspline, Hypoelastic, Line> bar{"bar", {}, {.density = 1, .young = 1, .poisson = 0}};
    fill(bar, Vector<Line>{100.}, Vector<Line>{1200.}, .5);
    EXPECT_TRUE(worth_threads(bar.size()));
    for (std::size_t p = 0; p < bar.size(); ++p) bar.v(0)[p] = .4 + .05 * std::sin(.1 * double(p));
    return Solver<QuadraticBspline, Hypoelastic, Musl, Line>{Grid<Line>{Vector<Line>{0.}, 1, {1400}}, std::move(bar)};
  };
  expect_same_bits(make, [](auto& solver) {
    solver.run(150);
    EXPECT_NEAR(solver.body().x(0)[0], 100.25 + .4 * 150, 3);
  });
}

/// Particles in the way that they are looked at with shared masses: a row farther from their strips than any step lets
/// them go, where every other strip would touch the same nodes.
TEST(SameBits, SharedMassesOfParticlesThatHaveDrifted) {
  Body<Ugimp, Hypoelastic> block{"block", {}, {.density = 1, .young = 1, .poisson = .25}};
  fill(block, {2, 4}, {26, 40}, .5);
  Grid<PlaneStrain<>> grid{{0, 0}, 1, {28, 44}};
  ParticleOrder order;
  locate(block, grid, order);
  for (std::size_t s = 0; s + 1 < order.strip_begin.size(); ++s)
    for (std::size_t p = order.strip_begin[s]; p < order.strip_begin[s + 1]; ++p)
      block.x(1)[p] = 4. * double(s) + (s % 4 < 2 ? 5.1 : -1.9);
  const auto stiffness = [&](int threads) {
    use_threads(threads);
    SharedMass<decltype(block)> shares;
    shares.share(block, order, grid);
    std::vector<double> most;
    for (std::size_t p = 0; p < block.size(); ++p) most.push_back(shares.stiffness(block, p, grid).most);
    return most;
  };
  const auto first = stiffness(1);
  EXPECT_GT(*std::max_element(first.begin(), first.end()), 0);
  for (int trial = 0; trial < 20; ++trial)
    for (const int threads : {2, 3, 8}) EXPECT_TRUE(stiffness(threads) == first) << threads << " threads";
}

/// Domains that pass the neighbourhood of their strip go to a serial tail; without it they would break the colouring.
TEST(SameBits, DomainsWiderThanABlock) {
  const auto make = [] {
    Body<Cpdi, Hypoelastic> body{"body", {}, {1000, 1e6, .3}};
    fill(body, {.5, .5}, {3.5, 3.5}, .025, [](const auto&) { return true; });
    for (std::size_t p = 0; p < body.size(); ++p) {
      body.v(0)[p] = std::sin(7. * double(p)), body.v(1)[p] = std::cos(3. * double(p));
      if (p % 31 == 0) body.store_F(p, {2, 0, 0, 0, 28 + .01 * double(p % 13), 0, 0, 0, 1});  // .7 m high: 7 cells
    }
    return Solver<Cpdi, Hypoelastic, Usl>{Grid<PlaneStrain<>>{{0, 0}, .1, {40, 40}}, std::move(body)};
  };
  expect_same_bits(make, steps(40));
}

/// Splines reach one node further than hats, FMPM sends nodal fields to the particles and back within the step, and
/// APIC keeps columns that are reordered with the body.
template <class Shape, class Integrator>
void expect_same_bits_of_discs(const Integrator& integrator) {
  const auto make = [&] {
    Body<Shape, NeoHookean> discs{"discs", {}, {.density = 1000, .young = 1000, .poisson = .3}};
    fill(discs, {0, 0}, {1, 1}, .01, disc(.3, .3, .2), {1, 1});
    fill(discs, {0, 0}, {1, 1}, .01, disc(.7, .7, .2), {-1, -1});
    EXPECT_TRUE(worth_threads(discs.size()));
    Solver<Shape, NeoHookean, Integrator> solver{Grid<PlaneStrain<>>{{0, 0}, .02, {50, 50}}, std::move(discs)};
    solver.integrator = integrator;
    return solver;
  };
  expect_same_bits(make, steps(60));
}
TEST(SameBits, SplinesAndFmpm) {
  expect_same_bits_of_discs<CubicBspline>(Fmpm{.order = 4, .interval = 3});
  expect_same_bits_of_discs<QuadraticBspline>(Fmpm{.order = 2});
  expect_same_bits_of_discs<CpdiQuad>(Fmpm{.order = 2});
}
TEST(SameBits, HatsWithEveryExplicitUpdate) {
  expect_same_bits_of_discs<Linear>(Usf{});
  expect_same_bits_of_discs<Linear>(Usl{});
  expect_same_bits_of_discs<Cpdi>(Usf{});
  expect_same_bits_of_discs<Ugimp>(FullMassFlip{});
}
TEST(SameBits, Apic) {
  expect_same_bits_of_discs<QuadraticBspline>(Apic{});
  expect_same_bits_of_discs<CpdiQuad>(Apic{});
}

/// Rock under its weight between rollers: the relaxation, and the run that goes on from it with what rests asleep.
TEST(SameBits, RelaxationAndRest) {
  const auto make = [] {
    Body<CpdiQuad, Hypoelastic> rock{"rock", {}, {2660, 5e10, .25}};
    fill(rock, {0, 0}, {1, 1}, .0125);
    Solver<CpdiQuad, Hypoelastic, DynamicRelaxation<>> solver{Grid<PlaneStrain<>>{{0, 0}, .025, {40, 40}},
                                                              std::move(rock)};
    solver.body_force = Vector<PlaneStrain<>>(0, -10);
    for (const int side : {0, 1}) solver.boundary.face(0, side) = Rollers<PlaneStrain<>>{};
    solver.boundary.face(1, 0) = Rollers<PlaneStrain<>>{};
    return solver;
  };
  expect_same_bits(make, steps(100));
  const auto make_kicked = [&] {
    auto relaxed = make();
    steps(100)(relaxed);
    Solver<CpdiQuad, Hypoelastic, Musl> solver{relaxed.grid, relaxed.body()};
    solver.body_force = relaxed.body_force;
    solver.boundary = relaxed.boundary;
    auto& rock = solver.body();
    for (std::size_t p = 0; p < rock.size(); ++p)
      if (rock.x(0)[p] + rock.x(1)[p] < .2) rock.v(0)[p] = 1;
    solver.let_rest(.1);
    EXPECT_GT(std::ranges::count(solver.grid.asleep, 1), 10);
    return solver;
  };
  expect_same_bits(make_kicked, steps(100));
}

TEST(SameBits, BallsInSpace) {
  using S = Spatial<>;
  const auto make = [] {
    Body<Cpgimp, NeoHookean, S> balls{"balls", {}, {.density = 1000, .young = 1000, .poisson = .3}};
    for (const double at : {.3, .7})
      fill(
          balls, {0, 0, 0}, {1, 1, 1}, .025, [=](const auto& x) { return (x - Vector<S>::Constant(at)).norm() < .2; },
          Vector<S>::Constant(at < .5 ? 1 : -1));
    EXPECT_TRUE(worth_threads(balls.size()));
    return Solver<Cpgimp, NeoHookean, Usl, S>{Grid<S>{{0, 0, 0}, .05, {20, 20, 20}}, std::move(balls)};
  };
  expect_same_bits(make, steps(40));
}

TEST(StateHash, SeesWhatTheIntegratorKeeps) {
  Body<Linear, Hypoelastic> body{"body", {}, {}};
  fill(body, {0, 0}, {1, 1}, .25);
  for (std::size_t p = 0; p < body.size(); ++p) body.v(0)[p] = body.x(1)[p];
  const auto hash_after_a_step = [&](auto integrator) {
    Solver<Linear, Hypoelastic, decltype(integrator)> solver{Grid<PlaneStrain<>>{{0, 0}, .5, {2, 2}}, body};
    solver.step(1e-9);
    StateHash h;
    h.add(&solver.time, sizeof solver.time);
    add_state(h, solver.body());
    return std::pair{state_hash(solver), h.value()};
  };
  const auto [flip, flip_body] = hash_after_a_step(Usl{});
  const auto [apic, apic_body] = hash_after_a_step(Apic{});
  EXPECT_EQ(flip, flip_body);
  EXPECT_NE(apic, apic_body);
}

TEST(StateHash, SeesEveryColumnCornerAndQuad) {
  Body<CpdiQuad, Hypoelastic> body{"body", {}, {}};
  fill(body, {0, 0}, {1, 1}, .25);
  const auto hash = [](const auto& b) {
    StateHash h;
    add_state(h, b);
    return h.value();
  };
  const auto start = hash(body);
  auto other = body;
  EXPECT_EQ(hash(other), start);
  other.v(1)[3] = -0.0;  // one bit
  EXPECT_NE(hash(other), start);
  other = body;
  other.shape.corner[5][0] = std::nextafter(other.shape.corner[5][0], 1);
  EXPECT_NE(hash(other), start);
  other = body;
  std::swap(other.shape.quad[0], other.shape.quad[1]);
  EXPECT_NE(hash(other), start);
  StateHash empty, letter;
  letter.add("a", 1);
  EXPECT_EQ(empty.value(), 0xcbf29ce484222325u);  // the published test vectors of FNV-1a
  EXPECT_EQ(letter.value(), 0xaf63dc4c8601ec8cu);
}

}  // namespace
