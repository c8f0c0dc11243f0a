// SPDX-License-Identifier: MIT
#include <mpm/mpm.hpp>
#include <gtest/gtest.h>
#include <random>

// CPDI2 by way of its shared corners against the plain form, each particle's own sixteen node visits.
namespace {

using namespace mpm;
using Space = PlaneStrain<>;
using Rock = Body<CpdiQuad, Hypoelastic>;

struct CornerNodesTest : testing::Test {
  static constexpr int n = 12;
  const UniformBodyForce<Space> weight{Vector<Space>{0, -10}};
  Rock body{"rock", {}, {}};
  Grid<Space> plain{{0, 0}, 1, {9, 9}}, fast = plain;
  std::mt19937 random{7};
  ParticleOrder order;
  Transfer<Rock, Usl> transfer;

  double number() { return std::uniform_real_distribution<double>(-1, 1)(random); }

  void SetUp() override {
    // Quadrilaterals of half a cell, every corner moved by up to a fifth of one; some lie on the grid's faces.
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        body.shape.corner.push_back({0.1 + i * .75 + .2 * number(), .1 + j * .75 + .2 * number()});
    const auto at = [](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) add_quad(body, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    for (std::size_t p = 0; p < body.size(); ++p) {
      auto state = body.state(p);
      state.stress = {number(), number(), number(), number(), 0, 0};
      body.store(p, state);
      for (int d = 0; d < 2; ++d) body.v(d)[p] = number();
    }
    locate(body, plain, order);
    transfer.locate(body, fast);
  }
  template <class Field>
  static void expect_equal(const Field& a, const Field& b, double scale) {
    for (std::size_t i = 0; i < a.size(); ++i)
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(a[i][d], b[i][d], 1e-13 * scale) << "node " << i;
  }
};

TEST_F(CornerNodesTest, ScattersMassAndMomentumAsThePlainFormDoes) {
  scatter_momentum(body, order, plain, plain.velocity);
  transfer.scatter_momentum(body, fast, fast.velocity);
  for (std::size_t i = 0; i < plain.mass.size(); ++i) EXPECT_NEAR(plain.mass[i], fast.mass[i], 1e-10);
  expect_equal(plain.velocity, fast.velocity, 1000);
  EXPECT_GT(*std::max_element(plain.mass.begin(), plain.mass.end()), 500);
}

TEST_F(CornerNodesTest, ScattersForceAsThePlainFormDoes) {
  scatter_force(body, order, plain, weight, 0);
  transfer.scatter_force(body, fast, weight, 0);
  expect_equal(plain.increment, fast.increment, 1e4);
}

TEST_F(CornerNodesTest, GathersAndStrainsAsThePlainFormDoes) {
  for (std::size_t i = 0; i < plain.velocity.size(); ++i) {
    plain.velocity[i] = fast.velocity[i] = {number(), number()};
    plain.increment[i] = fast.increment[i] = {number(), number()};
  }
  Rock other = body;
  gather_velocity(body, plain, Usl{.flip = .9});
  transfer.fetch_velocity(fast);
  transfer.fetch_increment(fast);
  gather_velocity(other, transfer.nodes(fast), Usl{.flip = .9});
  for (std::size_t p = 0; p < body.size(); ++p) {
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(body.v(d)[p], other.v(d)[p], 1e-14);
    const auto L = velocity_gradient<Space>(make_stencil(body, p, plain), plain.velocity, 0.);
    const auto corners =
        velocity_gradient<Space>(make_stencil(body, p, transfer.nodes(fast)), transfer.nodes(fast).velocity, 0.);
    EXPECT_NEAR(L.xx, corners.xx, 1e-13);
    EXPECT_NEAR(L.xy, corners.xy, 1e-13);
    EXPECT_NEAR(L.yx, corners.yx, 1e-13);
    EXPECT_NEAR(L.yy, corners.yy, 1e-13);
  }
}

}  // namespace
