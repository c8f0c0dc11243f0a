// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/method.hpp>
#include <cstdlib>
#include <exception>

// The step is certain: random fills of every method, from one particle an edge to twenty, with holes, jitter, stretched
// and sheared domains, at faces and axes, never grow.
namespace {

using namespace mpm::atlas;

int most_particles(int dimension) {
  return dimension == 1 ? 30 : dimension == 2 ? 25 : 12;
}
/// Calls f(method, fill, random) for random fills of the methods whose step is a matrix, or of the others, in turn: of
/// one in `share` of 2000, or of as many as the environment says.
template <class F>
void for_each_fill(bool matrix, int share, const F& f) {
  const char* const asked = std::getenv("MPM_FILLS");
  const int count = (asked ? std::atoi(asked) : 2000) / share;
  std::vector<const Method*> asked_for;
  for (const Method& m : methods())
    if (m.has_matrix == matrix) asked_for.push_back(&m);
  for (int k = 0; k < count; ++k) {
    const Method& method = *asked_for[std::size_t(k) % asked_for.size()];
    SCOPED_TRACE(testing::Message() << "fill " << k << ", " << method.name());
    Random random(static_cast<unsigned>(k));
    try {
      f(method, random_fill(method.dimension, most_particles(method.dimension), random), random);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

// Every state at once: the 2^20th power of the step's matrix would show a growth of a millionth a step. At the share s
// of the limit, symplectic Euler swaps velocity for stress and back: root mean square growth of up to sqrt((q +
// 1/q)/2), q = (1 + s)/(1 - s), which is 2.13 at s = .8.
TEST(CertainStep, NoFillGrows) {
  for_each_fill(true, 1, [](const Method& method, const Fill& fill, Random& random) {
    const auto step = method.at_rest(fill, random);
    EXPECT_LT(growth(step->matrix(.8 * step->certain()), 20), 2.13);
  });
}
// Those that keep something between steps beside the particles' velocities and stresses: a thousand of the solver's own
// steps each. From a random state the norm swings, by 3 at most; what grows is soon beyond a thousand.
TEST(CertainStep, NorDoThoseWithColumnsOfTheirOwn) {
  for_each_fill(false, 10, [](const Method& method, const Fill& fill, Random& random) {
    EXPECT_LT(method.run(fill, random, 1000), 5);
  });
}

// Where a face cuts the box of a particle, its weights have their centre beside it: APIC swings round that centre.
TEST(CertainStep, ApicStandsWhereFacesCutBoxes) {
  for (const char* space : {"1-D", "2-D", "3-D"})
    for (const double x : {.02, .05, .1, .2}) {
      Random random{1};
      const Fill fill{.per_edge = 1, .count = {1, 1, 1}, .offset = {x, x, x}, .stretch = {.45, .45, .45}};
      EXPECT_LT(find_method(space, "Ugimp", "APIC").run(fill, random, 1000), 5) << space << " at " << x;
    }
}

/// Of the certain step, over blocks of two particles an edge at random places, means.
struct Shares {
  double of_nodes = 0;  ///< in 2/w of the nodes with lumped masses
  double of_limit = 0;  ///< in the step beyond which something grows
  double irons = 0;     ///< of the step of particles that move, in the same
};
Shares shares(const Method& method) {
  constexpr int fills = 4;
  Shares shares;
  for (int k = 0; k < fills; ++k) {
    Random random(static_cast<unsigned>(k));
    std::uniform_real_distribution<> place(0, 1);
    const int count = method.dimension == 1 ? 12 : method.dimension == 2 ? 5 : 3;
    const Fill fill{.count = {count, count, count},
                    .offset = {place(random), place(random), place(random)},
                    .margin = {2, 2, 2},
                    .poisson = method.dimension == 1 ? 0 : .2};
    const auto step = method.at_rest(fill, random);
    shares.of_nodes += step->certain() / step->nodal_limit() / fills;
    const double limit = true_limit(*step);
    shares.of_limit += step->certain() / limit / fills;
    shares.irons += step->irons() / limit / fills;
  }
  return shares;
}
// With the nodes' masses shared by need the certain step is near the nodes' own limit, from below. USL strains with
// velocities that the remap has not smoothed, so that it stands up to dt^2 w^2 = 4/(2 - p) for a mode of which the
// particles keep the share p; a particle alone in a cell has p = 0, and the certain step holds for it. USF and MUSL
// stand up to 4/p, and are certain only as far as p may be 1.
TEST(CertainStep, ShareInWhatTheIntegratorStands) {
  const auto expect = [](const char* space, const char* shape, double of_nodes, double of_usl, double irons_of_usl,
                         double of_musl) {
    const Shares musl = shares(find_method(space, shape, "MUSL")), usl = shares(find_method(space, shape, "USL"));
    EXPECT_NEAR(musl.of_nodes, of_nodes, .02) << space << ' ' << shape;
    EXPECT_NEAR(musl.of_limit, of_musl, .02) << space << ' ' << shape;
    EXPECT_NEAR(usl.of_limit, of_usl, .02) << space << ' ' << shape;
    EXPECT_NEAR(usl.irons, irons_of_usl, .02) << space << ' ' << shape;
  };
  expect("1-D", "Ugimp", 0.93, 0.90, 0.72, 0.45);
  expect("1-D", "QuadraticBspline", 0.90, 0.86, 0.76, 0.46);
  expect("1-D", "CubicBspline", 0.86, 0.82, 0.72, 0.49);
  expect("1-D", "Cpdi", 0.90, 0.87, 0.81, 0.51);
  expect("2-D", "Ugimp", 0.82, 0.79, 0.66, 0.41);
  expect("2-D", "Cpdi", 0.82, 0.80, 0.80, 0.44);
  expect("2-D", "CpdiQuad", 0.82, 0.80, 0.80, 0.44);
  expect("2-D", "QuadraticBspline", 0.79, 0.76, 0.71, 0.43);
  expect("2-D", "CubicBspline", 0.78, 0.74, 0.70, 0.49);
  expect("3-D", "Ugimp", 0.79, 0.76, 0.64, 0.45);
  expect("3-D", "QuadraticBspline", 0.79, 0.74, 0.69, 0.45);
  expect("3-D", "CubicBspline", 0.84, 0.77, 0.75, 0.47);
}

/// Largest growth a step of blocks of two particles a cell on a line, at a step in h/c.
double growth_at(double cfl, const char* shape, const char* integrator) {
  double largest = 0;
  for (const double offset : {.05, .3, .55, .8}) {
    Random random{1};
    const Fill fill{.count = {16, 1, 1}, .offset = {offset, 0, 0}, .margin = {2, 2, 2}};
    largest = std::max(largest, find_method("1-D", shape, integrator).at_rest(fill, random)->growth_rate(cfl, 600));
  }
  return largest;
}
// What stands beyond a cell a step: with USL the cubic spline only, and with MUSL everything, as the remap keeps
// little of the shortest waves.
TEST(CflAboveOne, LastStandsWithCubicSplinesOnly) {
  for (const char* shape : {"Linear", "Ugimp", "Cpgimp", "Cpdi", "QuadraticBspline"})
    EXPECT_GT(growth_at(1.05, shape, "USL"), 1.05) << shape;
  EXPECT_LT(growth_at(1.05, "CubicBspline", "USL"), 1.003);
  EXPECT_GT(growth_at(1.2, "CubicBspline", "USL"), 1.05);
}
TEST(CflAboveOne, ModifiedLastStands) {
  for (const char* shape : {"Linear", "Ugimp", "Cpgimp", "Cpdi", "QuadraticBspline", "CubicBspline"})
    EXPECT_LT(growth_at(1.2, shape, "MUSL"), 1.003) << shape;
  EXPECT_GT(growth_at(2.4, "Cpdi", "MUSL"), 1.05);
}

/// Blocks with edges, or points, a little beside the nodes or half way between them.
void expect_no_spike(const Method& method, double beside) {
  for (const double place : {0., .25, .5, .75}) {
    Random random{1};
    const int deep = method.dimension == 3 ? 1 : 2;
    const Fill fill{
        .count = {3, 2, deep}, .offset = {place + beside, place + beside, place + beside}, .margin = {2, 2, 2}};
    EXPECT_LT(method.run(fill, random, 200), 3) << method.name() << " at " << place << " + " << beside;
  }
}
// A particle, or a corner of its domain, slid past a node by a millionth of a cell or less: neither a NaN nor a
// spike, though the node beyond has next to no mass. Every shape, integrator and space.
TEST(SlidPastANode, NothingHappens) {
  for (const Method& method : methods())
    for (const double beside : {1e-6, -1e-6}) expect_no_spike(method, beside);
}

}  // namespace
