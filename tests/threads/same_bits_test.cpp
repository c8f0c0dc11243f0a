// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mpm/analysis/state_hash.hpp>
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
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

/// Runs the scene that `make` sets up on 1, 2, 3 and 8 threads; `moved(before, after)` says whether enough happened.
template <class Make>
void expect_same_bits(int steps, const Make& make) {
  std::uint64_t first = 0;
  for (const int threads : {1, 2, 3, 8}) {
    use_threads(threads);
    auto solver = make();
    const auto start = state_hash(solver);
    for (int i = 0; i < steps; ++i) solver.step();
    const auto hash = state_hash(solver);
    EXPECT_NE(hash, start);
    if (threads == 1) first = hash;
    EXPECT_EQ(hash, first) << threads << " threads";
  }
}

constexpr auto disc = [](double x, double y, double radius) {
  return [=](const auto& at) { return std::hypot(at[0] - x, at[1] - y) < radius; };
};

TEST(SameBits, CollidingDiscs) {
  expect_same_bits(60, [] {
    Body<Cpgimp, NeoHookean> discs{"discs", {}, {.density = 1000, .young = 1000, .poisson = .3}};
    fill(discs, {0, 0}, {1, 1}, .025, disc(.3, .3, .2), {1, 1});
    fill(discs, {0, 0}, {1, 1}, .025, disc(.7, .7, .2), {-1, -1});
    return Solver<Cpgimp, NeoHookean, Musl>{Grid<PlaneStrain<>>{{0, 0}, .05, {20, 20}}, std::move(discs)};
  });
}

/// A charge that bursts a block of rock: all kinds of shapes, particles that wander between blocks of the grid.
TEST(SameBits, BlastOfMixedBodies) {
  using Rock = WithTensileLaw<JohnsonHolmquist2>;
  using Shapes = PerBody<CpdiQuad, Ugimp, Ugimp>;
  using Laws = PerBody<Rock, JonesWilkinsLee, PolynomialEos>;
  expect_same_bits(120, [] {
    const double h = .01;
    Body<CpdiQuad, Rock> rock{"rock", {}, granite_paper()};
    fill(rock, {0, 0}, {.4, .4}, h / 2, [](const auto& x) { return std::hypot(x[0] - .2, x[1] - .2) > .04; });
    Body<Ugimp, JonesWilkinsLee> charge{"charge", {}, petn_1260()};
    fill(charge, {0, 0}, {.4, .4}, h / 4, disc(.2, .2, .03));
    Body<Ugimp, PolynomialEos> air{"air", {}, mpm::air()};
    fill(air, {0, 0}, {.4, .4}, h / 4,
         [](const auto& x) { return std::abs(std::hypot(x[0] - .2, x[1] - .2) - .035) < .005; });
    Solver<Shapes, Laws, Musl> solver{Grid<PlaneStrain<>>{{0, 0}, h, {40, 40}}, std::move(rock), std::move(charge),
                                      std::move(air)};
    solver.boundary.face(0, 0) = Rollers<PlaneStrain<>>{};
    const auto quiet =
        Quiet<PlaneStrain<>>::from(2660, granite_elastic().tangent(granite_elastic().initial<double>(), 1.));
    solver.boundary.face(1, 1) = quiet;
    solver.hold_quiet_faces();
    return solver;
  });
}

/// Domains wider than a block go to a serial tail; without it they would break the colouring.
TEST(SameBits, DomainsWiderThanABlock) {
  expect_same_bits(40, [] {
    Body<Cpdi, Hypoelastic> body{"body", {}, {1000, 1e6, .3}};
    fill(body, {.5, .5}, {3.5, 3.5}, .025, [](const auto&) { return true; });
    for (std::size_t p = 0; p < body.size(); ++p) {
      body.v(0)[p] = std::sin(7. * double(p)), body.v(1)[p] = std::cos(3. * double(p));
      if (p % 31 == 0) body.store_F(p, {2, 0, 0, 0, 28 + .01 * double(p % 13), 0, 0, 0, 1});  // .7 m high: 7 cells
    }
    return Solver<Cpdi, Hypoelastic, Usl>{Grid<PlaneStrain<>>{{0, 0}, .1, {40, 40}}, std::move(body)};
  });
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
