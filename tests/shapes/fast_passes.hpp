// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
#include <random>

// The passes that a solver takes, in lanes and by corners, against the plain ones, particle by particle on the grid.
namespace mpm {
namespace {

template <class ShapeT, class LawT, class SpaceT>
struct Combination {
  using Shape = ShapeT;
  using Law = LawT;
  using Space = SpaceT;
};

/// Particles at random in a grid whose lower faces they touch, moving, strained and stressed.
template <class C>
class FastPasses : public ::testing::Test {
 protected:
  using S = typename C::Space;
  using Scalar = typename S::Scalar;
  using B = Body<typename C::Shape, typename C::Law, S>;
  using Passes = Transfer<B, Usl>;
  static constexpr int D = S::dimension;
  static constexpr bool in_float = std::is_same_v<Scalar, float>;
  static constexpr double round_off = in_float ? 2e-4 : 1e-11;

  B body{"body", {}, {}};
  Grid<S> grid;
  UniformBodyForce<S> weight;
  std::mt19937 random{7};

  Scalar number(double size = 1) { return Scalar(std::uniform_real_distribution<double>(-size, size)(random)); }

  void SetUp() override {
    Vector<S> origin = Vector<S>::Zero(), upper;
    std::array<int, D> cells;
    constexpr int lengths[] = {in_float ? 9 : 78, 9, 4};  // more than a block, but for floats on a line
    cells.fill(lengths[D - 1] + (D == 3 ? 3 : 2));
    if (S::hoop) origin[0] = Scalar(.5);
    for (int d = 0; d < D; ++d) upper[d] = origin[d] + Scalar(lengths[D - 1]);
    if constexpr (std::is_same_v<typename C::Law, JonesWilkinsLee>) body.law = petn_1260();  // the default is slack
    fill(body, origin, upper, Scalar(.5));
    grid = Grid<S>(origin, 1, cells);
    grid.strain_velocity = grid.velocity;
    weight = Vector<S>::Constant(-10);
    for (std::size_t p = 0; p < body.size(); ++p) disturb(p);
    if constexpr (requires { body.shape.corner; })
      for (auto& x : body.shape.corner)
        for (double& y : x) y = std::abs(y + double(number(.1)));
  }
  void disturb(std::size_t p) {
    for (int d = 0; d < D; ++d) {
      body.v(d)[p] = number();
      if constexpr (B::Shape::domain_motion != DomainMotion::corners) body.x(d)[p] += number(.24);
    }
    Tensor<Scalar> L{number(), number(), 0, number(), number(), 0, 0, 0, 0};
    if constexpr (D == 1) L = {number(), 0, 0, 0, 0, 0, 0, 0, 0};
    if constexpr (D == 3) L.zz = number(), L.xz = number(), L.zx = number(), L.yz = number(), L.zy = number();
    if constexpr (S::hoop) L.zz = number();
    if (p % 97 == 0) L.xx = 25;  // boxes wider than a cell
    StepLimits<Scalar> limits;
    strain(body, body.law, p, 1, L, Scalar(1), Scalar(0), Scalar(.05), limits);
  }
  void disturb_nodes() {
    for (std::size_t n = 0; n < grid.size(); ++n)
      for (int d = 0; d < D; ++d) {
        grid.velocity[n][d] = number();
        grid.increment[n][d] = number();
        grid.strain_velocity[n][d] = number();
      }
  }
  template <class Field>
  static void expect_equal(const Field& plain, const Field& fast) {
    Scalar scale = 0;
    for (const auto& v : plain) scale = std::max(scale, Vector<S>(v).norm());
    ASSERT_GT(scale, 0);
    for (std::size_t n = 0; n < plain.size(); ++n)
      EXPECT_NEAR((plain[n] - fast[n]).norm() / scale, 0, round_off) << "node " << n;
  }
  static void expect_equal(const B& plain, const B& fast) {
    for (int c = 0; c < B::column_count; ++c) {
      double scale = 1e-30;
      for (std::size_t p = 0; p < plain.size(); ++p) scale = std::max(scale, std::abs(double(plain.columns()[c][p])));
      for (std::size_t p = 0; p < plain.size(); ++p)
        EXPECT_NEAR(double(plain.columns()[c][p] - fast.columns()[c][p]) / scale, 0, round_off)
            << "column " << c << " of particle " << p;
    }
    EXPECT_NEAR(plain.stress_work, fast.stress_work, round_off * std::abs(plain.stress_work));
    EXPECT_NEAR(plain.viscous_work, fast.viscous_work, round_off * std::abs(plain.viscous_work));
  }
};

TYPED_TEST_SUITE_P(FastPasses);

TYPED_TEST_P(FastPasses, GiveTheNodesWhatThePlainOnesGive) {
  auto fast = this->grid;
  ParticleOrder order;
  locate(this->body, this->grid, order);
  for_each_coloured(order, [&](std::size_t p) {
    scatter_plainly<What::momentum_and_forces>(this->body, p, this->grid, this->grid.velocity, this->weight, 0);
  });
  typename TestFixture::Passes passes;
  passes.locate(this->body, fast);
  passes.template scatter<What::momentum_and_forces>(this->body, fast, fast.velocity, this->weight, 0);
  double total = 0, most = 0;
  for (std::size_t n = 0; n < fast.size(); ++n) total += fast.mass[n], most = std::max(most, double(fast.mass[n]));
  EXPECT_GT(total, 1);
  for (std::size_t n = 0; n < fast.size(); ++n)
    EXPECT_NEAR(fast.mass[n], this->grid.mass[n], TestFixture::round_off * most) << "node " << n;
  this->expect_equal(this->grid.velocity, fast.velocity);
  this->expect_equal(this->grid.increment, fast.increment);
}

TYPED_TEST_P(FastPasses, GiveInPartsWhatTheyGiveAtOnce) {
  auto parts = this->grid;
  typename TestFixture::Passes passes;
  passes.locate(this->body, parts);
  passes.locate(this->body, this->grid);
  passes.template scatter<What::momentum_and_forces>(this->body, this->grid, this->grid.velocity, this->weight, 0);
  passes.template scatter<What::momentum>(this->body, parts, parts.velocity, this->weight, 0);
  passes.template scatter<What::forces>(this->body, parts, parts.velocity, this->weight, 0);
  this->expect_equal(this->grid.velocity, parts.velocity);
  this->expect_equal(this->grid.increment, parts.increment);
  auto mass = this->grid;
  std::fill(mass.mass.begin(), mass.mass.end(), 0);
  passes.template scatter<What::mass>(this->body, mass, mass.velocity, this->weight, 0);
  for (std::size_t n = 0; n < mass.size(); ++n)
    EXPECT_NEAR(mass.mass[n], this->grid.mass[n], TestFixture::round_off * (1 + this->grid.mass[n])) << "node " << n;
}

TYPED_TEST_P(FastPasses, SmoothAsThePlainOneDoes) {
  this->disturb_nodes();
  auto plain = this->grid.velocity, fast = plain;
  for (auto* out : {&plain, &fast})
    for (auto& v : *out) v.setZero();
  typename TestFixture::Passes passes;
  passes.locate(this->body, this->grid);
  passes.scatter_interpolated(this->body, this->grid, this->grid.velocity, fast);
  for (std::size_t p = 0; p < this->body.size(); ++p)
    scatter_interpolated(this->body, p, this->grid, this->grid.velocity, plain);
  this->expect_equal(plain, fast);
}

TYPED_TEST_P(FastPasses, MoveAndStrainAsThePlainOnesDo) {
  using Real = typename TestFixture::Scalar;
  const Real dt(.01);
  typename TestFixture::Passes passes;
  passes.locate(this->body, this->grid);
  this->disturb_nodes();
  constexpr bool move = TestFixture::B::Shape::domain_motion != DomainMotion::corners;
  const Usl blend{.flip = .9};
  std::vector<StrainWork> partial;
  std::vector<StepLimits<Real>> limits;

  auto plain = this->body, fast = this->body;
  gather_velocity(plain, ChunkList(plain.size()), this->grid, blend);
  EXPECT_EQ(update_stress<move>(plain, ChunkList(plain.size()), this->grid, this->grid.velocity, OwnDilatation{},
                                Real(1), Real(0), dt, partial, limits),
            plain.size());
  EXPECT_EQ((passes.template update<true, Strained::by_first, true>(fast, this->grid, blend, 0, dt)), fast.size());
  this->expect_equal(plain, fast);

  plain = fast = this->body;
  gather_velocity(plain, ChunkList(plain.size()), this->grid, blend);
  EXPECT_EQ(update_stress<move>(plain, ChunkList(plain.size()), this->grid, this->grid.strain_velocity, OwnDilatation{},
                                Real(1), Real(0), dt, partial, limits),
            plain.size());
  passes.template update<true, Strained::none, false>(fast, this->grid, blend, 0, dt);
  EXPECT_EQ((passes.template update<false, Strained::by_second, true>(fast, this->grid, blend, 0, dt)), fast.size());
  this->expect_equal(plain, fast);
}

TYPED_TEST_P(FastPasses, CarryAffineVelocitiesAsThePlainOnesDo) {
  auto& rock = this->body;
  auto fast = this->grid;
  ParticleOrder order;
  locate(rock, this->grid, order);
  locate(rock, fast, order);
  Columns<typename TestFixture::Scalar, TestFixture::D * TestFixture::D> given, plain, seen;
  for (auto* columns : {&given, &plain, &seen}) columns->resize(rock.size());
  for (int c = 0; c < TestFixture::D * TestFixture::D; ++c)
    for (std::size_t p = 0; p < rock.size(); ++p) given[c][p] = this->number();
  for_each_coloured(order, [&](std::size_t p) { Apic::add_momentum(rock, p, given, this->grid, this->grid.velocity); });
  Apic::scatter_momentum(rock, order, given, fast, fast.velocity);
  this->expect_equal(this->grid.velocity, fast.velocity);
  for (std::size_t n = 0; n < fast.size(); ++n)
    EXPECT_NEAR(fast.mass[n], this->grid.mass[n], TestFixture::round_off * rock.mass()[0]) << "node " << n;

  this->disturb_nodes();
  for (std::size_t p = 0; p < rock.size(); ++p) Apic::find_columns(rock, p, this->grid, plain);
  Apic::gather_columns(rock, ChunkList(rock.size()), this->grid, seen);
  for (int c = 0; c < TestFixture::D * TestFixture::D; ++c)
    for (std::size_t p = 0; p < rock.size(); ++p)
      EXPECT_NEAR(plain[c][p], seen[c][p], TestFixture::round_off) << "column " << c << " of particle " << p;
}

TYPED_TEST_P(FastPasses, FindTheStableStepThatThePlainOneFinds) {
  using Real = typename TestFixture::Scalar;
  auto& rock = this->body;
  for (std::size_t p = 0; p < rock.size(); ++p) {  // moduli over density are the largest of a chunk: alike here
    rock.store(p, rock.law.template initial<Real>());
    rock.volume()[p] = rock.mass()[p] / Real(rock.law.density);
    for (int d = 0; d < TestFixture::D; ++d) rock.v(d)[p] = 0;
  }
  const auto place_some = [&](bool beside_face) {
    constexpr Real touch = 3 / steepest_slope<Real>;  // just enough of a node to count
    const Real places[] = {3, Real(3.002), Real(3.004), Real(3.5) + touch, Real(3.75) + touch};
    if constexpr (TestFixture::B::Shape::domain_motion != DomainMotion::corners) {
      for (int d = 0; d < TestFixture::D; ++d)
        for (std::size_t p = 0; p < std::size(places); ++p) rock.x(d)[p] = this->grid.origin()[d] + places[p];
      if (beside_face) rock.x(0)[std::size(places)] = this->grid.origin()[0] + Real(.2);
    }
  };
  place_some(false);
  typename TestFixture::Passes passes;
  passes.locate(rock, this->grid);
  EXPECT_EQ(passes.stable_step(rock, this->grid), stable_step(rock, ChunkList(rock.size()), this->grid))
      << "before the first step";
  passes.template update<false, Strained::by_first, false>(rock, this->grid, Usl{}, 0, 0);  // at rest
  const Real plain = stable_step(rock, ChunkList(rock.size()), this->grid), fast = passes.stable_step(rock, this->grid);
  EXPECT_LE(fast, plain * Real(1 + 1e-5));
  EXPECT_GE(fast, plain * Real(.85)) << "the largest terms of a chunk need not meet in one particle";

  passes.locate(rock, this->grid);
  passes.template scatter<What::momentum_and_forces, true>(rock, this->grid, this->grid.velocity, this->weight, 0);
  const Real seen = passes.stable_step(rock, this->grid);  // on the way of another pass, lane by lane
  EXPECT_LE(seen, plain * Real(1 + 1e-5));
  EXPECT_GE(seen, fast * Real(1 - 1e-5));

  // Moved by too much for anything to be kept: the other pass alone finds it. Beside a face splines are steeper.
  for (auto& v : this->grid.velocity) v = Vector<typename TestFixture::S>::Unit(TestFixture::D - 1) * Real(1e-3);
  passes.template update<false, Strained::by_first, true>(rock, this->grid, Usl{}, 0, Real(20));
  for (auto& v : this->grid.velocity) v.setZero();  // its round-off is a compression, which viscosity resists
  for (const bool beside_face : {false, true}) {
    place_some(beside_face);
    passes.locate(rock, this->grid);
    const Real moved = stable_step(rock, ChunkList(rock.size()), this->grid),
               found = passes.stable_step(rock, this->grid);
    passes.template scatter<What::momentum_and_forces, true>(rock, this->grid, this->grid.velocity, this->weight, 0);
    const Real seen_alone = passes.stable_step(rock, this->grid);
    EXPECT_LE(found, moved * Real(1 + 1e-5)) << beside_face;
    EXPECT_LE(seen_alone, moved * Real(1 + 1e-5)) << beside_face;
    EXPECT_GE(seen_alone, found * Real(1 - 1e-5)) << beside_face;
  }
}

REGISTER_TYPED_TEST_SUITE_P(FastPasses, GiveTheNodesWhatThePlainOnesGive, GiveInPartsWhatTheyGiveAtOnce,
                            SmoothAsThePlainOneDoes, MoveAndStrainAsThePlainOnesDo,
                            CarryAffineVelocitiesAsThePlainOnesDo, FindTheStableStepThatThePlainOneFinds);

}  // namespace
}  // namespace mpm
