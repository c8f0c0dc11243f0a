// SPDX-License-Identifier: MIT
#include <mpm/analysis/manufactured.hpp>
#include <gtest/gtest.h>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace {
using namespace mpm;
using namespace mpm::analysis;
using std::numbers::pi;

Eigen::Matrix3d matrix(const Tensor<double>& a) {
  Eigen::Matrix3d m;
  m << a.xx, a.xy, a.xz, a.yx, a.yy, a.yz, a.zx, a.zy, a.zz;
  return m;
}

/// The law as stated, P = lambda ln J F^-T + mu (F - F^-T).
Eigen::Matrix3d first_piola_kirchhoff(const NeoHookean& law, const Eigen::Matrix3d& F) {
  const double mu = law.young / (2 * (1 + law.poisson)), nu = law.poisson;
  const double lambda = law.young * nu / ((1 + nu) * (1 - 2 * nu));
  const Eigen::Matrix3d inverse = F.inverse().transpose();
  return lambda * std::log(F.determinant()) * inverse + mu * (F - inverse);
}

/// Central difference of sixth order.
template <class Function>
auto derivative(const Function& f, double h) {
  return ((f(3 * h) - f(-3 * h) - 9 * (f(2 * h) - f(-2 * h)) + 45 * (f(h) - f(-h))) / (60 * h)).eval();
}

template <int D>
Point<D> shifted(Point<D> X, int axis, double by) {
  X[axis] += by;
  return X;
}

/// Holds velocity and deformation gradient to the differences of the displacement, and the body force to
/// u_tt - Div P/rho0. `h` and `dt` are small against the length and time in which the solution changes.
template <int D, class Solution>
void expect_balance(const Solution& s, const Point<D>& X, double t, double h, double dt) {
  const Point<D> v = derivative([&](double d) { return s.displacement(X, t + d); }, dt);
  EXPECT_LT((s.velocity(X, t) - v).norm(), 1e-8 * (1 + v.norm()));

  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  Point<D> divergence = Point<D>::Zero();
  for (int j = 0; j < D; ++j) {
    F.col(j).template head<D>() += derivative([&](double d) { return s.displacement(shifted<D>(X, j, d), t); }, h);
    divergence += derivative(
        [&](double d) -> Point<D> {
          const Eigen::Matrix3d G = matrix(s.deformation_gradient(shifted<D>(X, j, d), t));
          return first_piola_kirchhoff(s.material, G).col(j).template head<D>();
        },
        h);
  }
  EXPECT_LT((matrix(s.deformation_gradient(X, t)) - F).norm(), 1e-8);
  const Point<D> acceleration = derivative([&](double d) { return s.velocity(X, t + d); }, dt);
  const Point<D> b = acceleration - divergence / s.material.density;
  EXPECT_GT(b.norm(), 1e-3 * (acceleration.norm() + divergence.norm() / s.material.density));
  EXPECT_LT((s.body_force(X, t) - b).norm(), 1e-7 * (acceleration.norm() + divergence.norm() / s.material.density));
}

template <int D>
void expect_axis_aligned() {
  Point<D> X;
  for (const double x : {.13, .38, .77}) {
    for (int k = 0; k < D; ++k) X[k] = x + .07 * k * (1 - x);
    for (const double t : {.0009, .0037, .0121}) expect_balance<D>(AxisAligned<D>{}, X, t, 1e-3, 1e-5);
  }
}

TEST(AxisAligned, BalancesMomentum) {
  expect_axis_aligned<1>();
  expect_axis_aligned<2>();
  expect_axis_aligned<3>();
}

TEST(AxisAligned, HoldsItsFacesAndStartsStrained) {
  const AxisAligned<3> s;
  for (const double face : {0., 1.}) {
    EXPECT_NEAR(s.displacement({face, face, face}, .0041).norm(), 0, 1e-16);
    EXPECT_NEAR(s.velocity({face, face, face}, .0041).norm(), 0, 1e-13);
  }
  const Point<3> start = s.displacement({.5, .5, .5}, 0);
  EXPECT_EQ(start[0], 0);
  EXPECT_NEAR(start[1], .05 * std::sqrt(.75), 1e-15);
  EXPECT_NEAR(start[2], -.05 * std::sqrt(.75), 1e-15);
  EXPECT_NEAR(s.velocity({.5, .5, .5}, 0)[0], .05 * pi * 100, 1e-12);  // c = 100 m/s
}

TEST(AxisAligned, ConstantsOfTheSource) {
  const NeoHookean law = AxisAligned<1>{}.material;
  EXPECT_NEAR(shear_modulus(law.young, law.poisson), 3846.15, 5e-3);
  EXPECT_NEAR(law.young / (3 * (1 - 2 * law.poisson)), 8333.33, 5e-3);
}

TEST(Vortex, BodyForceOfTheProbe) {
  Vortex s;
  const Point<2> exact = s.body_force({.9, .35}, .37);
  s.material.poisson = 1000 / (2 * 384.615) - 1;  // the figures are for a shear modulus rounded to 384.615 Pa
  const Point<2> b = s.body_force({.9, .35}, .37);
  EXPECT_NEAR(b[0], -9.36747, 5e-6);
  EXPECT_NEAR(b[1], 3.13220, 5e-6);
  EXPECT_LT((exact - b).norm(), 2e-5);
}

TEST(Vortex, BalancesMomentum) {
  for (const double R : {.78, .91, 1.04, 1.21})
    for (const double t : {.05, .37, .8, 1.3})
      expect_balance<2>(Vortex{}, {R * std::cos(3 * R), R * std::sin(3 * R)}, t, 1e-3, 1e-3);
}

TEST(Vortex, TurnsCirclesAndHoldsItsRims) {
  const Vortex s;
  const Point<2> top = s.displacement({1, 0}, .5);  // the middle circle turns by A = 1 rad at t = 1/2
  EXPECT_NEAR(top[0], std::cos(1) - 1, 1e-15);
  EXPECT_NEAR(top[1], std::sin(1), 1e-15);
  EXPECT_NEAR(s.velocity({1, 0}, 0)[1], pi, 1e-14);
  for (const double rim : {Vortex::inner, Vortex::outer}) {
    EXPECT_EQ(s.displacement({0, rim}, .37).norm(), 0);
    EXPECT_EQ(s.velocity({0, rim}, .37).norm(), 0);
    EXPECT_EQ(s.deformation_gradient({0, rim}, .37).xy, 0);
  }
  EXPECT_NEAR(determinant(s.deformation_gradient({.6, .6}, .37)), 1, 1e-14);
}

TEST(ExpandingRing, BalancesMomentum) {
  for (const double R : {.42, .5, .57})
    for (const double t : {.0007, .0041, .0133})
      expect_balance<2>(ExpandingRing{}, {R * std::cos(9 * R), R * std::sin(9 * R)}, t, 1e-4, 1e-5);
}

TEST(ExpandingRing, RimsAreFree) {
  const ExpandingRing s;
  const double t = .0033;
  for (const double rim : {.4, .6}) {
    const Point<2> n{.6, .8};
    const Eigen::Matrix3d P = first_piola_kirchhoff(s.material, matrix(s.deformation_gradient(rim * n, t)));
    EXPECT_LT((P.topLeftCorner<2, 2>() * n).norm(), 1e-7);  // of hoop stresses of MPa
    EXPECT_GT(P.norm(), 1e5);
  }
}

TEST(ExpandingRing, SwingsByTheAmplitude) {
  const ExpandingRing s;
  EXPECT_NEAR(s.displacement({.6, 0}, .005)[0], .1, 1e-15);  // a quarter of the period 2/c, c = 100 m/s
  EXPECT_NEAR(s.displacement({0, .6}, .015)[1], -.1, 1e-15);
  EXPECT_NEAR(s.displacement({.4, 0}, .005)[0], 2.8 / 27, 1e-15);
  EXPECT_NEAR(s.velocity({.6, 0}, 0)[0], .1 * pi * 100, 1e-12);
}

/// The body forces are for the law that the framework runs: its Cauchy stress gives the same P = J sigma F^-T.
TEST(Manufactured, LawIsTheFrameworks) {
  const Vortex s;
  const Tensor<double> F =
      AxisAligned<3>{}.deformation_gradient({.3, .6, .2}, .003) * s.deformation_gradient({.9, .35}, .37);
  auto state = s.material.initial<double>();
  Increment<double> step;
  step.F = F;
  step.J = determinant(F);
  s.material.update(state, step);
  const auto& c = state.stress;
  const Eigen::Matrix3d sigma = matrix({c.xx, c.xy, c.zx, c.xy, c.yy, c.yz, c.zx, c.yz, c.zz});
  const Eigen::Matrix3d P = first_piola_kirchhoff(s.material, matrix(F));
  EXPECT_LT((step.J * sigma * matrix(F).inverse().transpose() - P).norm(), 1e-12 * P.norm());
}
}  // namespace
