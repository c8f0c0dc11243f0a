// SPDX-License-Identifier: MIT
#pragma once
#include "particle.hpp"
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>

// What every constitutive law must obey, in double and in float. One line in a test file sweeps a law:
//
//   MPM_SWEEP_LAW(MyRock, my::Rock{.density = 2700, .young = 50e9});
//
// An explosive must be given as burnt: a burn under way feeds energy in.
namespace mpm::laws {

/// A closed loop of deformation, leaving I and returning to it at t = 1.
template <class Real>
struct Loop {
  Tensor<Real> a, b;

  Tensor<Real> at(double t) const {
    const Real angle = Real(2 * M_PI * t);
    return Tensor<Real>::identity() + std::sin(angle) * a + (1 - std::cos(angle)) * b;
  }
};

/// A swept law: `Case::law()` is the law, `Real` the scalar.
template <class Case, class Scalar>
struct Swept {
  using Real = Scalar;
  using Law = decltype(Case::law());
  static Particle<Law, Real> particle() { return {.law = Case::law()}; }

  /// Strains that reach into each regime: small for a solid of some GPa, large where a fluid has only its volume.
  static constexpr Real strain() { return Real(Fluid<Law> ? 0.15 : 0.006); }
  static constexpr double round_off(double slack) { return slack * double(std::numeric_limits<Real>::epsilon()); }
  /// A settled particle somewhere on a random loop.
  static Particle<Law, Real> somewhere(Random<Real>& random) {
    auto p = particle();
    const Loop<Real> loop{random.tensor(strain()), random.tensor(strain() / 2)};
    for (int i = 1; i <= 50; ++i) p.go(loop.at(i * double(random.number(Real(0.2), 1)) / 50));
    p.settle();
    return p;
  }
};

template <class T>
class LawSweep : public ::testing::Test {};
TYPED_TEST_SUITE_P(LawSweep);

TYPED_TEST_P(LawSweep, HoldingStillChangesNothing) {
  Random<typename TypeParam::Real> random;
  for (int n = 0; n < 40; ++n) {
    auto p = TypeParam::somewhere(random);
    const auto before = p.stress();
    const double stiffness = double(p.tangent().longitudinal);
    p.step({}, p.F);
    EXPECT_LE(largest(p.stress() - before), TypeParam::round_off(20) * (stiffness + largest(before)));
  }
}

TYPED_TEST_P(LawSweep, ASpinTurnsTheStressAndNothingElse) {
  using Real = typename TypeParam::Real;
  Random<Real> random;
  auto p = TypeParam::somewhere(random);
  const auto start = p.stress();
  const auto L = (Real(2 * std::tan(M_PI / 360)) / p.dt) * Tensor<Real>{0, -1, 0, 1, 0, 0, 0, 0, 0};  // one degree
  const auto R = step_rotation(L, p.dt);
  auto turned = start;
  for (int degree = 1; degree <= 720; ++degree) {
    p.step(L, R * p.F);
    turned = rotated(turned, R);
    if (degree % 90 != 0) continue;
    EXPECT_LE(largest(p.stress() - turned), TypeParam::round_off(4000) * double(p.tangent().longitudinal)) << degree;
  }
  EXPECT_LE(largest(p.stress() - start), TypeParam::round_off(4000) * double(p.tangent().longitudinal));
}

TYPED_TEST_P(LawSweep, FrameIndifference) {
  using Real = typename TypeParam::Real;
  Random<Real> random;
  for (int n = 0; n < 10; ++n) {
    auto still = TypeParam::particle(), moving = still;
    const Loop<Real> loop{random.tensor(TypeParam::strain()), random.tensor(TypeParam::strain() / 2)};
    const auto axis = random.tensor(Real(0.005));
    const auto R = step_rotation(axis + Real(-1) * transpose(axis), Real(1));
    auto Q = Tensor<Real>::identity();
    double scale = 0;
    for (int i = 1; i <= 300; ++i) {
      const auto F = loop.at(0.6 * i / 300);
      Q = R * Q;
      still.go(F);
      // Relative gradient f and its Cayley transform 2 (f - I)(f + I)^-1, so that a rotation is a rotation.
      const auto f = Q * F * Particle<typename TypeParam::Law, Real>::inverse(moving.F);
      const auto I = Tensor<Real>::identity();
      moving.step((2 / moving.dt) * ((f + Real(-1) * I) * Particle<typename TypeParam::Law, Real>::inverse(f + I)),
                  Q * F);
      scale = std::max({scale, largest(still.stress()), 1e-3 * double(still.tangent().longitudinal)});
    }
    EXPECT_LE(largest(moving.stress() - rotated(still.stress(), Q)), (sizeof(Real) == 4 ? 2e-2 : 1e-2) * scale);
  }
}

/// Work of a closed cycle over the largest on its way, in cells of the given size.
template <class P, class Real>
double cycle_work(P p, const Loop<Real>& loop, Real cell) {
  p.cell = cell;
  double highest = 0;
  const int steps = 2000;
  for (int i = 1; i <= steps; ++i) {
    p.go(loop.at(double(i) / steps));
    highest = std::max(highest, std::abs(p.work));
  }
  return p.work / highest;
}

/// No law gives energy back, and one that remembers nothing takes none: a solid without history, and a fluid without
/// bulk viscosity (in a cell of no size), whose energy is the work done on it. Of the work on the way no more may be
/// missing than round-off and what trapezoids of 2000 steps are off, 2e-7 for the stiffest gas. A law in rate form has
/// no potential, though: its cycle is closed to first order in the strain only, to either side.
TYPED_TEST_P(LawSweep, AClosedCycleGivesNoEnergyBack) {
  using Real = typename TypeParam::Real;
  using Law = typename TypeParam::Law;
  constexpr bool has_potential = Fluid<Law> || needs_deformation_gradient<Law>;
  constexpr bool remembers = !Fluid<Law> && Law::history.size() > 0;
  const double slack = 1e-6 + TypeParam::round_off(200) + (has_potential ? 0 : 2 * double(TypeParam::strain()));
  Random<Real> random;
  for (int n = 0; n < 20; ++n) {
    const auto p = TypeParam::particle();
    const Loop<Real> loop{random.tensor(TypeParam::strain()), random.tensor(TypeParam::strain() / 2)};
    const double inviscid = cycle_work(p, loop, Real(0));
    EXPECT_GE(inviscid, -slack);
    EXPECT_GE(cycle_work(p, loop, p.cell), -slack);
    if (!remembers) {
      EXPECT_LE(inviscid, slack);
    }
  }
}

/// Largest rho c^2 of plane waves along random directions n: power iteration on the polarisation a, with the traction
/// that a small step of gradient a (x) n adds. Iterating keeps loading and unloading branches apart, as a matrix of
/// differences would not.
template <class Real, class P>
double acoustic_stiffness(const P& start, Random<Real>& random, int directions) {
  const Real h = Real(sizeof(Real) == 4 ? 1e-4 : 1e-7);
  double found = 0;
  for (int n = 0; n < directions; ++n) {
    const auto Q = random.rotation();
    const Real nx = Q.xx, ny = Q.yx, nz = Q.zx;
    Real ax = nx, ay = ny, az = nz;
    for (int iteration = 0; iteration < 40; ++iteration) {
      const auto H = h * Tensor<Real>{ax * nx, ax * ny, ax * nz, ay * nx, ay * ny, ay * nz, az * nx, az * ny, az * nz};
      auto p = start;
      p.cell = 0;  // no bulk viscosity: its share of the step is the solver's factor
      p.step((1 / p.dt) * H, (Tensor<Real>::identity() + H) * p.F);
      const auto d = (1 / h) * (p.stress() - start.stress());
      const Real tx = d.xx * nx + d.xy * ny + d.zx * nz, ty = d.xy * nx + d.yy * ny + d.yz * nz,
                 tz = d.zx * nx + d.yz * ny + d.zz * nz, size = std::sqrt(tx * tx + ty * ty + tz * tz);
      if (size == 0) break;
      if (iteration > 20) found = std::max(found, double(ax * tx + ay * ty + az * tz));
      if (iteration == 0 && n % 2 == 1)
        ax = -ax, ay = -ay, az = -az;  // compression in one half, tension in the other
      else
        ax = tx / size, ay = ty / size, az = tz / size;
    }
  }
  return found;
}

TYPED_TEST_P(LawSweep, TheTangentIsTheStiffnessAtRest) {
  using Real = typename TypeParam::Real;
  Random<Real> random;
  const auto p = TypeParam::particle();
  const double found = acoustic_stiffness<Real>(p, random, 6);
  EXPECT_NEAR(double(p.tangent().longitudinal) / found, 1, sizeof(Real) == 4 ? 0.1 : 1e-3);
}

TYPED_TEST_P(LawSweep, TheTangentBoundsTheStiffnessAnywhere) {
  using Real = typename TypeParam::Real;
  Random<Real> random;
  for (int n = 0; n < 60; ++n) {
    const auto p = TypeParam::somewhere(random);
    const auto bound = p.tangent();
    EXPECT_LE(acoustic_stiffness<Real>(p, random, 6),
              (sizeof(Real) == 4 ? 1.1 : 1.001) * double(std::max(bound.longitudinal, bound.shear)));
  }
}

TYPED_TEST_P(LawSweep, EnergyLostIsWorkDone) {
  using Real = typename TypeParam::Real;
  if constexpr (requires(typename TypeParam::Law::template State<Real> s) { s.energy; }) {
    Random<Real> random;
    for (int n = 0; n < 10; ++n) {
      auto p = TypeParam::particle();
      const double start = double(p.state.energy);
      double work = 0;
      for (int i = 1; i <= 100; ++i) {
        const double pressure = double(p.state.pressure), J = double(p.J);
        p.go(random.number(Real(0.97), Real(1.04)) * p.F);
        work += (double(p.J) - J) * (pressure + double(p.state.pressure)) / 2;
      }
      EXPECT_NEAR(start - double(p.state.energy), work, TypeParam::round_off(100) * start);
      EXPECT_GT(std::abs(work), 1e-4 * start);
    }
  }
}

TYPED_TEST_P(LawSweep, StaysFiniteFarOut) {
  using Real = typename TypeParam::Real;
  Random<Real> random;
  for (const Real far : {Real(0.2), Real(0.5), Real(2), Real(5)}) {
    auto p = TypeParam::particle();
    for (int i = 1; i <= 1000; ++i) {
      const Real stretch = std::pow(far, Real(i) / 3000);
      p.go(stretch * (Tensor<Real>::identity() + random.tensor(Real(1e-3))));
      ASSERT_TRUE(std::isfinite(largest(p.stress()))) << p.J;
      ASSERT_TRUE(std::isfinite(p.tangent().longitudinal) && p.tangent().longitudinal >= 0) << p.J;
    }
  }
}

REGISTER_TYPED_TEST_SUITE_P(LawSweep, HoldingStillChangesNothing, ASpinTurnsTheStressAndNothingElse, FrameIndifference,
                            AClosedCycleGivesNoEnergyBack, TheTangentIsTheStiffnessAtRest,
                            TheTangentBoundsTheStiffnessAnywhere, EnergyLostIsWorkDone, StaysFiniteFarOut);

}  // namespace mpm::laws

/// Runs the sweep over one law: a name for the test and an expression that makes the law.
#define MPM_SWEEP_LAW(Name, ...)                                                                             \
  struct SweptCase##Name {                                                                                   \
    static auto law() { return __VA_ARGS__; }                                                                \
  };                                                                                                         \
  using SweptTypes##Name =                                                                                   \
      ::testing::Types<mpm::laws::Swept<SweptCase##Name, double>, mpm::laws::Swept<SweptCase##Name, float>>; \
  namespace mpm::laws {                                                                                      \
  INSTANTIATE_TYPED_TEST_SUITE_P(Name, LawSweep, SweptTypes##Name);                                          \
  }                                                                                                          \
  static_assert(mpm::Material<decltype(SweptCase##Name::law())>)
