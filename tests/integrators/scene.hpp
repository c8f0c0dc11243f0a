// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>
#include <mpm/analysis/energy.hpp>
#include <mpm/mpm.hpp>
#include <random>

// Bodies and combinations that the sweeps over integrators, shapes and spaces share.
namespace mpm::integrator_laws {

/// One combination; `Shape` x `Integrator` x `Space`.
template <class ShapeT, class IntegratorT, class SpaceT>
struct Combination {
  using Shape = ShapeT;
  using IntegratorType = IntegratorT;
  using S = SpaceT;
};

template <class... Lists>
struct Joined;
template <class... A>
struct Joined<::testing::Types<A...>> {
  using Type = ::testing::Types<A...>;
};
template <class... A, class... B, class... Rest>
struct Joined<::testing::Types<A...>, ::testing::Types<B...>, Rest...> {
  using Type = typename Joined<::testing::Types<A..., B...>, Rest...>::Type;
};
/// A shape with every explicit integrator.
template <class Shape, class S>
using EveryIntegrator =
    ::testing::Types<Combination<Shape, Usf, S>, Combination<Shape, Usl, S>, Combination<Shape, Musl, S>,
                     Combination<Shape, Fmpm, S>, Combination<Shape, FullMassFlip, S>, Combination<Shape, Apic, S>>;

/// Shapes with one integrator.
template <class S, class... Shapes>
using WithUsl = ::testing::Types<Combination<Shapes, Usl, S>...>;

/// Every shape with every integrator in the plane, and every shape and every integrator in each space where a
/// translation along the last axis is a rigid motion. A new shape costs one line a space.
using PlaneCombinations = typename Joined<  //
    EveryIntegrator<Linear, PlaneStrain<>>, EveryIntegrator<Ugimp, PlaneStrain<>>,
    EveryIntegrator<Cpgimp, PlaneStrain<>>, EveryIntegrator<Cpdi, PlaneStrain<>>,
    EveryIntegrator<CubicBspline, PlaneStrain<>>, EveryIntegrator<CpdiQuad, PlaneStrain<>>,
    EveryIntegrator<MeanDilatation<Ugimp>, PlaneStrain<>>>::Type;
using UniaxialCombinations = typename Joined<EveryIntegrator<Ugimp, Uniaxial<>>,
                                             WithUsl<Uniaxial<>, Linear, Cpgimp, Cpdi, QuadraticBspline>>::Type;
using AxisymmetricCombinations =
    typename Joined<EveryIntegrator<Ugimp, Axisymmetric<>>,
                    WithUsl<Axisymmetric<>, Linear, Cpgimp, Cpdi, QuadraticBspline, MeanDilatation<Ugimp>>>::Type;
using SpatialCombinations =
    typename Joined<EveryIntegrator<Ugimp, Spatial<>>,
                    WithUsl<Spatial<>, Linear, Cpgimp, QuadraticBspline, CubicBspline, MeanDilatation<Ugimp>>>::Type;

constexpr double density = 1000, young = 1e6, cell = 0.1;
inline double sound_speed() {
  const Hypoelastic law{density, young, 0.3};
  return std::sqrt(law.tangent(law.initial<double>(), 1.0).longitudinal / density);
}

/// A block of 3 cells a side, two particles an edge, in a grid `length` cells long along the last axis and 7 across.
template <class Shape, class IntegratorType, class S>
auto block(int length) {
  constexpr int last = S::dimension - 1;
  Vector<S> origin = Vector<S>::Zero(), lower, upper;
  std::array<int, S::dimension> cells;
  cells.fill(7);
  cells[last] = length;
  if (S::hoop) origin[0] = 0.2;
  for (int d = 0; d < S::dimension; ++d) lower[d] = origin[d] + 2 * cell, upper[d] = lower[d] + 3 * cell;
  Body<Shape, Hypoelastic, S> body{"block", {}, {density, young, 0.3}};
  fill(body, lower, upper, cell / 2);
  return Solver<Shape, Hypoelastic, IntegratorType, S>{Grid<S>{origin, cell, cells}, std::move(body)};
}

}  // namespace mpm::integrator_laws
