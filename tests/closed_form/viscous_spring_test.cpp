// SPDX-License-Identifier: MIT
#include <mpm/analysis/energy.hpp>
#include <problems/cavity.hpp>
#include <gtest/gtest.h>
#include <type_traits>

// Faces that know where the waves come from: their traction against Hooke's law, their work, and what they send back of
// a pulse beside what dashpots alone do.
namespace mpm {
namespace {

using Plane = PlaneStrain<>;

template <class S>
class OutgoingWave : public testing::Test {
 protected:
  static constexpr int spread = std::is_same_v<S, Radial<>> || std::is_same_v<S, Plane> ? 1 : 2;
  static constexpr double density = 2660, v_r = 3, u_r = 1e-3, v_across = 2, dt = 1e-9;
  static constexpr Moduli<double> moduli{5e10, 2e10};

  static Grid<S> grid() {
    std::array<int, S::dimension> cells;
    cells.fill(3);
    Vector<S> origin = Vector<S>::Constant(-1);
    if (S::hoop) origin[0] = 1;
    return {origin, 1, cells};
  }
  /// Hooke's law for an outgoing wave whose whole displacement is new (w = 0), and the dashpot across the radius.
  static Vector<S> expected(const Vector<S>& e, const Vector<S>& across, double r, int axis) {
    const double lambda = moduli.longitudinal - 2 * moduli.shear, c_p = std::sqrt(moduli.longitudinal / density);
    const double e_rr = -v_r / c_p - spread * u_r / (2 * r), e_tt = u_r / r;
    Vector<S> n = Vector<S>::Zero();
    n[axis] = 1;
    const Vector<S> sigma_n =
        lambda * (e_rr + spread * e_tt) * n + 2 * moduli.shear * (e_tt * n + (e_rr - e_tt) * e[axis] * e);
    return sigma_n - std::sqrt(density * moduli.shear) * e[axis] * across;
  }
};
using WaveSpaces = testing::Types<Plane, Radial<>, Axisymmetric<>, Spatial<>>;
TYPED_TEST_SUITE(OutgoingWave, WaveSpaces);

TYPED_TEST(OutgoingWave, MeetsTheStressItHasInOneLargeBody) {
  using S = TypeParam;
  constexpr int axis = S::dimension - 1;
  auto grid = this->grid();
  Vector<S> centre = Vector<S>::Zero();
  if (S::dimension > 1 && !S::hoop) centre[0] = .3;
  auto face = ViscousSpring<S>::from(this->density, this->moduli, centre);
  std::vector<Vector<S>> across;
  grid.for_each_on_face(axis, 1, [&](int node, const auto&) {
    const Vector<S> e = (grid.position(node) - centre).normalized();
    Vector<S> side = Vector<S>::Constant(this->v_across);
    across.push_back(side - e.dot(side) * e);
    grid.mass[node] = 1e4;  // so that the step changes little
    grid.velocity[node] = this->v_r * e + across.back();
    face.displacement.push_back(this->u_r);
  });
  face.absorb(grid, axis, 1, this->dt);
  std::size_t k = 0;
  grid.for_each_on_face(axis, 1, [&](int node, const auto& index) {
    const Vector<S> x = grid.position(node) - centre;
    const Vector<S> force = grid.mass[node] / this->dt * grid.increment[node];
    const Vector<S> exact =
        tributary_area(grid, axis, index) * this->expected(x.normalized(), across[k++], x.norm(), axis);
    EXPECT_LT((force - exact).norm(), 1e-4 * exact.norm());
  });
}

TEST(ViscousSpring, RefusesACentreBehindTheFace) {
  Grid<Plane> grid({0, 0}, 1, {2, 2});
  for (auto& m : grid.mass) m = 1;
  auto face = ViscousSpring<Plane>::from(1, {1, .3}, {3, 1});
  EXPECT_THROW(face.absorb(grid, 0, 1, .1), Error);
  EXPECT_NO_THROW(face.absorb(grid, 0, 0, .1));
}

// A pulse in a cylinder, to its outer face and back to the axis and again: what is missing has done its work there.
TEST(ViscousSpring, PaysForTheEnergyItTakes) {
  using S = Radial<>;
  const auto rock = granite_elastic();
  const auto moduli = rock.tangent(rock.initial<double>(), 1.0);
  Body<Ugimp, Hypoelastic, S> body("rock", {}, rock);
  fill(body, Vector<S>(0.0), Vector<S>(1.0), 1. / 80);
  for (std::size_t p = 0; p < body.size(); ++p) body.v(0)[p] = std::pow(std::sin(M_PI * body.x(0)[p]), 4);
  Solver<Ugimp, Hypoelastic, Musl, S> solver(Grid<S>(Vector<S>(0.0), 1. / 40, {40}), std::move(body));
  solver.boundary.face(0, 0) = Rollers<S>{};
  solver.boundary.face(0, 1) = ViscousSpring<S>::from(rock.density, moduli, Vector<S>(0.0));
  const double start = kinetic_energy(solver.body());
  solver.run(3 / std::sqrt(moduli.longitudinal / rock.density));
  const double left = kinetic_energy(solver.body()) + solver.body().stress_work;
  EXPECT_LT(left, .01 * start);
  EXPECT_NEAR(left - start, solver.boundary.work(), .01 * start);
}

/// The error of the hoop stress at 5 a, in per cent of its peak, from when the faces at 20 a first answer to 400 us. In
/// an endless block USL has .02.
template <class Integrator = Usl, class Face>
double sent_back(const Face& face, problems::CavityOptions options = {.cells = 2}) {
  options.side = 20, options.end = 400e-6, options.history_from = 150e-6;
  const int first = options.model == problems::Model::full ? 0 : 1;
  const auto surround = [&](auto& solver) {
    for (int d = 0; d < 2; ++d)
      for (int side = first; side < 2; ++side) solver.boundary.face(d, side) = face;
  };
  return 100 * problems::cavity<CpdiQuad, Integrator>(options, {}, surround).history;
}
const Hypoelastic rock = granite_elastic();
const Moduli<double> moduli = rock.tangent(rock.initial<double>(), 1.0);
const auto dashpots = Quiet<Plane>::from(rock.density, moduli);
ViscousSpring<Plane> springs_about(double x, double y) {
  return ViscousSpring<Plane>::from(rock.density, moduli, {x, y});
}

// Asked: at most 1 %.
TEST(ViscousSpring, SendsBackLittleOfWhatDashpotsDo) {
  EXPECT_NEAR(sent_back(dashpots), 2.1, .3);
  EXPECT_NEAR(sent_back(springs_about(0, 0)), .59, .1);
}

TEST(ViscousSpring, SendsBackLittleWithTheHoleOffTheCentre) {
  const problems::CavityOptions off{.cells = 2, .model = problems::Model::full, .offset = {10, 6}};
  EXPECT_NEAR(sent_back(dashpots, off), 1.5, .25);
  EXPECT_LT(sent_back(springs_about(5 * problems::hole, 3 * problems::hole), off), .32);
}

// A larger step leaves more of a wake: in an endless block MUSL has 1.8 at a/2.
TEST(ViscousSpring, SendsBackLittleInMusl) {
  EXPECT_LT(sent_back<Musl>(springs_about(0, 0), {.cells = 4}), .75);
}

}  // namespace
}  // namespace mpm
