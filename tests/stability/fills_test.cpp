// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <stability_atlas/fill_method.hpp>
#include <cstdlib>
#include <exception>

// The step is certain: random fills of every method, from one particle an edge to twenty, with holes, jitter, stretched
// and sheared domains, at faces and axes, never grow.
namespace {

using namespace mpm::atlas;

int most_particles(int dimension) {
  return dimension == 1 ? 30 : dimension == 2 ? 25 : 12;
}
/// Calls f(method, fill, random) for random fills of the methods whose step is linear, or of the others, in turn: of
/// one in `share` of 2000, or of as many as the environment says.
template <class F>
void for_each_fill(bool linear, int share, const F& f) {
  const char* const asked = std::getenv("MPM_FILLS");
  const int count = (asked ? std::atoi(asked) : 2000) / share;
  std::vector<const FillMethod*> methods;
  for (const FillMethod& m : fill_methods())
    if (bool(m.linear) == linear) methods.push_back(&m);
  for (int k = 0; k < count; ++k) {
    const FillMethod& method = *methods[std::size_t(k) % methods.size()];
    SCOPED_TRACE(testing::Message() << "fill " << k << ", " << method.name());
    Random random(static_cast<unsigned>(k));
    try {
      f(method, random_fill(method.dimension, most_particles(method.dimension), random), random);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

// Every state at once: the 2^20th power of the step's matrix would show a growth of a millionth a step. Of a step that
// only just stands, symplectic Euler swaps velocity for stress by up to 1/sqrt(1 - .8^2) = 1.7.
TEST(CertainStep, NoFillGrows) {
  for_each_fill(true, 1, [](const FillMethod& method, const Fill& fill, Random& random) {
    const auto step = method.linear(fill, random);
    EXPECT_LT(growth(step->matrix(.8 * step->certain()), 20), 1.7);
  });
}
// Those that keep something between steps beside the particles' velocities and stresses: a thousand of the solver's own
// steps each. From a random state the norm swings, by 3 at most; what grows is soon beyond a thousand.
TEST(CertainStep, NorDoThoseWithColumnsOfTheirOwn) {
  for_each_fill(false, 10, [](const FillMethod& method, const Fill& fill, Random& random) {
    EXPECT_LT(method.run(fill, random, 1000), 5);
  });
}

// Where a face cuts the box of a particle, its weights have their centre beside it: APIC swings round that centre.
TEST(CertainStep, ApicStandsWhereFacesCutBoxes) {
  for (const char* space : {"1-D", "2-D", "3-D"})
    for (const double x : {.02, .05, .1, .2}) {
      Random random{1};
      const Fill fill{.per_edge = 1, .count = {1, 1, 1}, .offset = {x, x, x}, .stretch = {.45, .45, .45}};
      EXPECT_LT(fill_method(space, "Ugimp", "APIC").run(fill, random, 1000), 5) << space << " at " << x;
    }
}

/// Over blocks of two particles an edge at random places.
struct Shares {
  double of_nodes = 0;  ///< mean share of Irons' step in 2/w of the nodes with lumped masses
  double of_limit = 0;  ///< mean share of the certain step in that beyond which something grows
  double least = 9;     ///< of the latter
};
Shares shares(const FillMethod& method, double irons_over_certain) {
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
    const auto step = method.linear(fill, random);
    const double share = step->certain() / true_limit(*step);
    shares.of_nodes += irons_over_certain * step->certain() / step->nodal_limit() / fills;
    shares.of_limit += share / fills;
    shares.least = std::min(shares.least, share);
  }
  return shares;
}
// Irons' bound, a particle at a time, against the nodes' own limit: what it costs not to know the neighbours.
TEST(CertainStep, IronsIsNearTheLimitOfTheNodes) {
  const auto expect = [](const char* space, const char* shape, double low, double high) {
    const double share = shares(fill_method(space, shape, "MUSL"), 1).of_nodes;
    EXPECT_GT(share, low) << space << ' ' << shape;
    EXPECT_LT(share, high) << space << ' ' << shape;
  };
  expect("1-D", "Ugimp", .70, .79);
  expect("1-D", "QuadraticBspline", .75, .84);
  expect("1-D", "CubicBspline", .72, .80);
  expect("1-D", "Cpdi", .80, .95);
  expect("2-D", "Ugimp", .64, .73);
  expect("2-D", "CpdiQuad", .78, .86);
  expect("2-D", "QuadraticBspline", .70, .79);
  expect("2-D", "CubicBspline", .69, .77);
}
// USL strains with velocities that the remap has not smoothed, so that it stands up to dt^2 w^2 = 4/(2 - p) for a mode
// of which the particles keep the share p; a particle alone in a cell has p = 0, and the certain step holds for it. USF
// and MUSL stand up to 4/p, and are certain only as far as p may be 1.
TEST(CertainStep, ShareInWhatTheIntegratorStands) {
  const auto expect = [](const char* space, const char* shape, double of_usl, double of_musl) {
    EXPECT_NEAR(shares(fill_method(space, shape, "USL"), std::sqrt(2.)).of_limit, of_usl, .04) << space << ' ' << shape;
    EXPECT_NEAR(shares(fill_method(space, shape, "MUSL"), 1).of_limit, of_musl, .03) << space << ' ' << shape;
  };
  expect("1-D", "Ugimp", .72, .36);
  expect("1-D", "QuadraticBspline", .76, .41);
  expect("1-D", "CubicBspline", .72, .43);
  expect("1-D", "Cpdi", .80, .45);
  expect("2-D", "Ugimp", .66, .34);
  expect("2-D", "CpdiQuad", .80, .44);
  expect("2-D", "QuadraticBspline", .71, .40);
  expect("2-D", "CubicBspline", .70, .46);
}

/// Largest growth a step of blocks of two particles a cell on a line, at a step in h/c.
double growth_at(double cfl, const char* shape, const char* integrator) {
  double largest = 0;
  for (const double offset : {.05, .3, .55, .8}) {
    Random random{1};
    const Fill fill{.count = {16, 1, 1}, .offset = {offset, 0, 0}, .margin = {2, 2, 2}};
    largest =
        std::max(largest, growth_rate(fill_method("1-D", shape, integrator).linear(fill, random)->matrix(cfl), 600));
  }
  return largest;
}
// What stands beyond a cell a step: with USL the cubic spline only, and with MUSL everything, as the remap keeps little
// of the shortest waves.
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
void expect_no_spike(const FillMethod& method, double beside) {
  for (const double place : {0., .25, .5, .75}) {
    Random random{1};
    const int deep = method.dimension == 3 ? 1 : 2;
    const Fill fill{
        .count = {3, 2, deep}, .offset = {place + beside, place + beside, place + beside}, .margin = {2, 2, 2}};
    EXPECT_LT(method.run(fill, random, 200), 3) << method.name() << " at " << place << " + " << beside;
  }
}
// A particle, or a corner of its domain, slid past a node by a millionth of a cell or less: neither a NaN nor a spike,
// though the node beyond has next to no mass. Every shape, integrator and space.
TEST(SlidPastANode, NothingHappens) {
  for (const FillMethod& method : fill_methods())
    for (const double beside : {1e-6, -1e-6}) expect_no_spike(method, beside);
}

}  // namespace
