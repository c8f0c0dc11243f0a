// SPDX-License-Identifier: MIT
#include "scene.hpp"

// A body force that differs between particles, and one that does not.
namespace mpm::integrator_laws {
namespace {

using S = PlaneStrain<>;

/// Differs from particle to particle, and in time.
struct Uneven {
  double scale = 1;
  template <class Body>
  Vector<S> operator()(const Body& body, std::size_t p, double time) const {
    return scale * Vector<S>{std::sin(50 * body.x(1)[p]), std::cos(70 * body.x(0)[p]) + time};
  }
};

template <class Shape>
void expect_sum_of_weight_mass_and_force() {
  Body<Shape, Hypoelastic> body{"block", {}, {density, young, 0.3}};
  fill(body, {.23, .23}, {.5, .5}, cell / 2);
  Solver<Shape, Hypoelastic, Usl, S, Uneven> solver{Grid<S>{{0, 0}, cell, {7, 7}}, std::move(body)};
  solver.body_force.scale = 3;
  solver.time = 0.7;
  solver.internal_forces();
  std::vector<Vector<S>> expected(solver.grid.size(), Vector<S>::Zero());
  const auto& placed = solver.body();
  double total = 0;
  for (std::size_t p = 0; p < placed.size(); ++p) {
    const Vector<S> b{3 * std::sin(50 * placed.x(1)[p]), 3 * (std::cos(70 * placed.x(0)[p]) + 0.7)};
    total += placed.mass()[p] * b.norm();
    for (const auto& [I, w, grad] : make_stencil(placed, p, solver.grid)) expected[I] += w * placed.mass()[p] * b;
  }
  double largest = 0;
  for (std::size_t n = 0; n < expected.size(); ++n) {
    EXPECT_LT((solver.grid.increment[n] - expected[n]).norm(), 1e-16 * total) << "node " << n;
    largest = std::max(largest, expected[n].norm());
  }
  EXPECT_GT(largest, 0.01 * total);
}
TEST(BodyForce, IsWeighedParticleByParticle) {
  expect_sum_of_weight_mass_and_force<Linear>();
  expect_sum_of_weight_mass_and_force<Cpgimp>();
  expect_sum_of_weight_mass_and_force<CpdiQuad>();
}

TEST(BodyForce, UniformIsAVector) {
  Solver<Linear, Hypoelastic, Usl> solver{Grid<S>{{0, 0}, 1, {1, 1}}, Body<Linear, Hypoelastic>{}};
  const auto at = [&] { return solver.body_force(solver.body(), 0, 1.); };
  EXPECT_EQ(at(), Vector<S>(0, 0));
  solver.body_force = {0, -9.81};
  EXPECT_EQ(at(), Vector<S>(0, -9.81));
  solver.body_force[0] = 2;
  EXPECT_EQ(at(), Vector<S>(2, -9.81));
  solver.body_force = Vector<S>{1, 3};
  EXPECT_EQ(at(), Vector<S>(1, 3));
  static_assert(sizeof solver.body_force == sizeof(Vector<S>));
}

}  // namespace
}  // namespace mpm::integrator_laws
