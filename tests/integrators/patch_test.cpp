// SPDX-License-Identifier: MIT
#include "scene.hpp"

// A uniform stress on a body that fills the box, held by tractions on its faces, is in equilibrium to round-off.
namespace mpm::integrator_laws {
namespace {

template <class ShapeT, class SpaceT>
struct Patch {
  using Shape = ShapeT;
  using S = SpaceT;
};
// A new shape costs one line. Splines in the plane and in space are held between walls below: the tractions here are
// those of hats, which differ within a cell of the edges of a face.
using Patches = ::testing::Types<Patch<Linear, Uniaxial<>>, Patch<Linear, PlaneStrain<>>, Patch<Linear, Axisymmetric<>>,
                                 Patch<Linear, Radial<>>, Patch<Linear, Spatial<>>, Patch<Ugimp, Uniaxial<>>,
                                 Patch<Ugimp, PlaneStrain<>>, Patch<Ugimp, Axisymmetric<>>, Patch<Ugimp, Radial<>>,
                                 Patch<Ugimp, Spatial<>>, Patch<Cpgimp, Uniaxial<>>, Patch<Cpgimp, PlaneStrain<>>,
                                 Patch<Cpgimp, Axisymmetric<>>, Patch<Cpgimp, Radial<>>, Patch<Cpgimp, Spatial<>>,
                                 Patch<Cpdi, Uniaxial<>>, Patch<Cpdi, PlaneStrain<>>, Patch<CpdiQuad, PlaneStrain<>>,
                                 Patch<QuadraticBspline, Uniaxial<>>, Patch<CubicBspline, Uniaxial<>>>;

/// In a space with a hoop direction only equal radial and hoop stresses are in equilibrium. An axial stress is left out
/// there: its share at a node is a quadratic integral, which particles meet to their quadrature only.
template <class S>
SymmetricTensor<double> uniform_stress() {
  if (S::hoop) return {-3e3, 0, -3e3, 0, 0, 0};
  if (S::dimension == 1) return {-3e3, 1e3, 2e3, 0, 0, 0};
  if (S::dimension == 2) return {-3e3, 2e3, -1e3, 1.5e3, 0, 0};
  return {-3e3, 2e3, -1e3, 1.5e3, -0.5e3, 0.7e3};
}

template <class S>
Vector<S> traction(const SymmetricTensor<double>& s, int axis, double sign) {
  const double rows[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  Vector<S> t;
  for (int d = 0; d < S::dimension; ++d) t[d] = sign * rows[axis][d];
  return t;
}

/// A body with the uniform stress that fills the box.
template <class Shape, class S>
auto patch(const SymmetricTensor<double>& stress) {
  Vector<S> lower, upper;
  std::array<int, S::dimension> cells;
  for (int d = 0; d < S::dimension; ++d) {
    cells[d] = 6 - d;
    lower[d] = 0.3, upper[d] = 0.3 + cell * cells[d];
  }
  Body<Shape, Hypoelastic, S> filled{"patch", {}, {density, young, 0.3}};
  fill(filled, lower, upper, cell / 2);
  if constexpr (requires { filled.shape.corner; }) {
    std::mt19937_64 engine{5};
    std::uniform_real_distribution<> shift(-0.15 * cell, 0.15 * cell);
    for (auto& [x, y] : filled.shape.corner) {
      if (std::min({x - lower[0], upper[0] - x, y - lower[1], upper[1] - y}) < 0.01 * cell) continue;
      x += shift(engine), y += shift(engine);
    }
    for (std::size_t p = 0; p < filled.size(); ++p) {
      filled.volume()[p] = filled.shape.weights(p).area, filled.mass()[p] = density * filled.volume()[p];
      const auto x = filled.shape.centroid(p);
      filled.x(0)[p] = x[0], filled.x(1)[p] = x[1];
    }
  }
  for (std::size_t p = 0; p < filled.size(); ++p) filled.store(p, {stress});
  return Solver<Shape, Hypoelastic, Usl, S>{Grid<S>{lower, cell, cells}, std::move(filled)};
}

template <class Solver>
void expect_rest(Solver& solver, const SymmetricTensor<double>& stress) {
  for (int i = 0; i < 20; ++i) solver.step();
  for (std::size_t p = 0; p < solver.body().size(); ++p) {
    EXPECT_LT(solver.body().velocity(p).norm(), 1e-12);
    const auto drift = solver.body().stress(p) - stress;
    EXPECT_LT(std::sqrt(inner(drift, drift)), 1e-8);
  }
}

template <class T>
class PatchTest : public ::testing::Test {};
TYPED_TEST_SUITE(PatchTest, Patches);

TYPED_TEST(PatchTest, UniformStressStays) {
  using S = typename TypeParam::S;
  const auto stress = uniform_stress<S>();
  auto solver = patch<typename TypeParam::Shape, S>(stress);
  for (int d = 0; d < S::dimension; ++d)
    for (int side : {0, 1})
      solver.boundary.face(d, side) =
          Traction<S>::on(solver.grid, d, side, [&](const auto&) { return traction<S>(stress, d, side ? 1 : -1); });

  solver.internal_forces();
  double internal = 0, unbalanced = 0;
  for (const auto& f : solver.grid.increment) internal = std::max(internal, f.norm());
  solver.boundary.load(solver.grid);
  for (const auto& f : solver.grid.increment) unbalanced = std::max(unbalanced, f.norm());
  EXPECT_GT(internal, 0.1 * 3e3 * std::pow(cell, S::dimension - 1) * (S::hoop ? solver.grid.origin()[0] : 1));
  EXPECT_LT(unbalanced, 1e-13 * internal);

  expect_rest(solver, stress);
}

/// Walls instead of tractions: what shapes need whose nodal shares of a face are not those of hats.
template <class Shape, class S>
void expect_rest_between_walls() {
  const SymmetricTensor<double> stress{-3e3, 2e3, -1e3, 0, 0, 0};
  auto solver = patch<Shape, S>(stress);
  for (int d = 0; d < S::dimension; ++d)
    for (int side : {0, 1}) solver.boundary.face(d, side) = Rollers<S>{};
  expect_rest(solver, stress);
  EXPECT_GT(solver.force_scale(), 0.1 * 3e3 * std::pow(cell, S::dimension - 1));
}
TEST(SplinePatch, UniformStressStaysBetweenWalls) {
  expect_rest_between_walls<QuadraticBspline, PlaneStrain<>>();
  expect_rest_between_walls<CubicBspline, PlaneStrain<>>();
  expect_rest_between_walls<QuadraticBspline, Spatial<>>();
  expect_rest_between_walls<CubicBspline, Spatial<>>();
}

}  // namespace
}  // namespace mpm::integrator_laws
