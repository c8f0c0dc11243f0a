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
// A new shape costs one line.
using Patches = ::testing::Types<Patch<Linear, Uniaxial<>>, Patch<Linear, PlaneStrain<>>, Patch<Linear, Axisymmetric<>>,
                                 Patch<Linear, Radial<>>, Patch<Linear, Spatial<>>, Patch<Ugimp, Uniaxial<>>,
                                 Patch<Ugimp, PlaneStrain<>>, Patch<Ugimp, Axisymmetric<>>, Patch<Ugimp, Radial<>>,
                                 Patch<Ugimp, Spatial<>>, Patch<Cpgimp, Uniaxial<>>, Patch<Cpgimp, PlaneStrain<>>,
                                 Patch<Cpgimp, Axisymmetric<>>, Patch<Cpgimp, Radial<>>, Patch<Cpgimp, Spatial<>>,
                                 Patch<Cpdi, Uniaxial<>>, Patch<Cpdi, PlaneStrain<>>, Patch<CpdiQuad, PlaneStrain<>>>;

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

template <class T>
class PatchTest : public ::testing::Test {};
TYPED_TEST_SUITE(PatchTest, Patches);

TYPED_TEST(PatchTest, UniformStressStays) {
  using S = typename TypeParam::S;
  Vector<S> lower, upper;
  std::array<int, S::dimension> cells;
  for (int d = 0; d < S::dimension; ++d) {
    cells[d] = 6 - d;
    lower[d] = 0.3, upper[d] = 0.3 + cell * cells[d];
  }
  Body<typename TypeParam::Shape, Hypoelastic, S> filled{"patch", {}, {density, young, 0.3}};
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
  const auto stress = uniform_stress<S>();
  for (std::size_t p = 0; p < filled.size(); ++p) filled.store(p, {stress});
  Solver<typename TypeParam::Shape, Hypoelastic, Usl, S> solver{Grid<S>{lower, cell, cells}, std::move(filled)};
  for (int d = 0; d < S::dimension; ++d)
    for (int side : {0, 1})
      solver.boundary.face(d, side) =
          Traction<S>::on(solver.grid, d, side, [&](const auto&) { return traction<S>(stress, d, side ? 1 : -1); });

  solver.internal_forces();
  double internal = 0, unbalanced = 0;
  for (const auto& f : solver.grid.increment) internal = std::max(internal, f.norm());
  solver.boundary.load(solver.grid);
  for (const auto& f : solver.grid.increment) unbalanced = std::max(unbalanced, f.norm());
  EXPECT_GT(internal, 0.1 * 3e3 * std::pow(cell, S::dimension - 1) * (S::hoop ? lower[0] : 1));
  EXPECT_LT(unbalanced, 1e-13 * internal);

  for (int i = 0; i < 20; ++i) solver.step();
  for (std::size_t p = 0; p < solver.body().size(); ++p) {
    EXPECT_LT(solver.body().velocity(p).norm(), 1e-12);
    const auto drift = solver.body().stress(p) - stress;
    EXPECT_LT(std::sqrt(inner(drift, drift)), 1e-8);
  }
}

}  // namespace
}  // namespace mpm::integrator_laws
