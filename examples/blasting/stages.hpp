// SPDX-License-Identifier: MIT
#pragma once
#include "laws.hpp"
#include "scene.hpp"
#include <mpm/analysis/kirsch.hpp>
#include <mpm/geometry/holed_block.hpp>
#include <mpm/geometry/lattice.hpp>
#include <mpm/mpm.hpp>
#include <algorithm>
#include <cmath>

// The two stages of Xiao et al. 2024, Fig. 7, each one instantiation of mpm::Solver.
namespace blasting {

using Space = mpm::PlaneStrain<double>;
using mpm::CpdiQuad;
using mpm::Ugimp;

/// A kind of rock: its law, the shape function of its particles, and the number type of the blast; it settles in
/// double.
template <class LawT, class ShapeT = CpdiQuad, class ScalarT = double>
struct Rock {
  using Law = LawT;
  using Shape = ShapeT;
  using BlastSpace = mpm::PlaneStrain<ScalarT>;
  using Body = mpm::Body<Shape, Law, Space>;
};

/// Stage 1: the rock alone settles under the in-situ stress.
template <class Rock>
using RelaxationSolver = mpm::Solver<typename Rock::Shape, typename Rock::Law, mpm::DynamicRelaxation<>, Space>;

/// Stage 2: rock, charge and air.
template <class Rock, class Integrator>
using BlastSolver = mpm::Solver<mpm::PerBody<typename Rock::Shape, Ugimp, Ugimp>,
                                mpm::PerBody<typename Rock::Law, mpm::JonesWilkinsLee, mpm::PolynomialEos>, Integrator,
                                typename Rock::BlastSpace>;

/// The block's half side as the grid can have it: a whole number of cells, at least what the scene asks.
inline int half_cells(const Scene& scene) {
  return static_cast<int>(std::ceil(scene.block.side / 2 / scene.grid.cell - 1e-9));
}
inline double half_side(const Scene& scene) {
  return half_cells(scene) * scene.grid.cell;
}

/// The grid fills the block; a quarter model is its upper right quadrant.
template <class S>
mpm::Grid<S> background(const Scene& scene) {
  using Scalar = typename S::Scalar;
  const int n = half_cells(scene);
  const Scalar cell = Scalar(scene.grid.cell), low = Scalar(-half_side(scene));
  if (scene.model == Model::quarter) return {{0, 0}, cell, {n, n}};
  return {{low, low}, cell, {2 * n, 2 * n}};
}

/// In-situ stress round a hole at the origin, tension positive; the paper's and the scene's magnitudes are
/// compressions.
inline mpm::analysis::Kirsch in_situ(const Scene& scene) {
  return {.horizontal = -scene.stress.horizontal,
          .vertical = -scene.stress.vertical,
          .radius = scene.hole.radius,
          .direction = scene.stress.direction * M_PI / 180};
}

/// Stress that the relaxation starts from at x: the far field, and on it what each hole alone would change by Kirsch's
/// solution, unless the scene starts as if there were none.
inline mpm::SymmetricTensor<double> starting_stress(const Scene& scene, double poisson, double x, double y) {
  const auto field = in_situ(scene);
  const auto far = field.far_field();
  auto s = far;
  if (scene.stress.start == StressStart::kirsch)
    for (std::size_t k = 0; k < scene.holes(); ++k) {
      const auto alone = field.stress(x - scene.hole.x[k], y - scene.hole.y[k]);
      s.xx += alone.xx - far.xx, s.yy += alone.yy - far.yy, s.xy += alone.xy - far.xy;
    }
  return {s.xx, s.yy, poisson * (s.xx + s.yy), s.xy, 0, 0};
}

/// The rock of the scene under the starting stress, each particle denser as the inverse of its equation of state
/// demands: quadrilaterals that follow the round wall, or squares whose centres lie outside the holes.
template <class Rock>
typename Rock::Body make_rock(const Scene& scene) {
  const auto law = rock_law<typename Rock::Law>(scene);
  typename Rock::Body rock("rock", {}, law);
  if constexpr (std::is_same_v<typename Rock::Shape, CpdiQuad>) {
    const mpm::geometry::HoledBlock block{.radius = scene.hole.radius,
                                          .centres = scene.hole_centres(),
                                          .half_side = half_side(scene),
                                          .particle_size = scene.rock.particle,
                                          .model = scene.model};
    rock = mpm::geometry::make_body<Space>("rock", block.mesh(), law);
  } else {
    const double half = half_side(scene), low = scene.model == Model::quarter ? 0 : -half;
    mpm::fill(rock, {low, low}, {half, half}, scene.rock.particle, [&](const mpm::Vector<Space>& x) {
      const auto [hole_x, hole_y] = scene.hole_centre(scene.nearest_hole(x[0], x[1]));
      return std::hypot(x[0] - hole_x, x[1] - hole_y) > scene.hole.radius;
    });
  }
  for (std::size_t p = 0; p < rock.size(); ++p) {
    const auto stress = starting_stress(scene, law.poisson, rock.x(0)[p], rock.x(1)[p]);
    rock.mass()[p] /= relative_volume(law, -trace(stress) / 3);
    rock.store(p, state_under(law, stress));
  }
  return rock;
}

/// Puts symmetry rollers on the cut faces of a quarter model, `face(axis, side)` on all others.
template <class S, class Solver, class F>
void set_faces(Solver& solver, const Scene& scene, const F& face) {
  for (int axis = 0; axis < 2; ++axis)
    for (int side = 0; side < 2; ++side) {
      if (scene.model == Model::quarter && side == 0) {
        solver.boundary.face(axis, side) = mpm::Rollers<S>{};
      } else {
        solver.boundary.face(axis, side) = face(axis, side);
      }
    }
}

/// Stage 1, ready to relax: tractions of the starting field on the outer faces.
template <class Rock>
RelaxationSolver<Rock> relaxation_stage(const Scene& scene) {
  RelaxationSolver<Rock> solver(background<Space>(scene), make_rock<Rock>(scene));
  const double poisson = solver.body().law.poisson;
  set_faces<Space>(solver, scene, [&](int axis, int side) {
    return mpm::Traction<Space>::on(solver.grid, axis, side, [&](const mpm::Vector<Space>& x) -> mpm::Vector<Space> {
      const auto s = starting_stress(scene, poisson, x[0], x[1]);
      const double n = side == 0 ? -1 : 1;
      return axis == 0 ? mpm::Vector<Space>(n * s.xx, n * s.xy) : mpm::Vector<Space>(n * s.xy, n * s.yy);
    });
  });
  return solver;
}

/// Fills the holes' cross-sections, or the quadrant of the one, with gas particles wherever `inside(x, y)`, offsets
/// from the hole's centre; masses and volumes are scaled so that they add up to the gas's true `area` a hole, which a
/// lattice meets only nearly.
template <class Law, class Inside>
mpm::Body<Ugimp, Law, Space> fill_gas(const Scene& scene, const char* name, const Law& law, double area,
                                      const Inside& inside) {
  const bool quarter = scene.model == Model::quarter;
  const double spacing = scene.grid.cell / scene.gas.particles_per_edge;
  const double extent = std::ceil(scene.hole.radius / spacing) * spacing;
  mpm::Body<Ugimp, Law, Space> gas(name, {}, law);
  for (std::size_t k = 0; k < scene.holes(); ++k) {
    const mpm::Vector<Space> centre(scene.hole.x[k], scene.hole.y[k]), half(extent, extent);
    mpm::fill(gas, quarter ? centre : mpm::Vector<Space>(centre - half), centre + half, spacing,
              [&](const mpm::Vector<Space>& x) { return inside(x[0] - centre[0], x[1] - centre[1]); });
  }
  double sum = 0;
  for (std::size_t p = 0; p < gas.size(); ++p) sum += gas.volume()[p];
  const double scale = (quarter ? 0.25 : double(scene.holes())) * area / sum;
  for (std::size_t p = 0; p < gas.size(); ++p) gas.volume()[p] *= scale, gas.mass()[p] *= scale;
  return gas;
}

/// The charge of every hole, lit at its delay; a programmed burn runs from the charge's centre on. (That burn lets
/// compression light the charge, too: a wave from another hole may come first.)
inline mpm::Body<Ugimp, mpm::JonesWilkinsLee, Space> make_charge(const Scene& scene) {
  const auto& c = scene.charge;
  const auto law = charge_law(scene);
  if (c.kind == ChargeKind::none) return {"charge", {}, law};
  auto charge = fill_gas(scene, "charge", law, M_PI * c.radius * c.radius,
                         [&](double x, double y) { return std::hypot(x - c.x, y - c.y) < c.radius; });
  for (std::size_t p = 0; p < charge.size(); ++p) {
    const double x = charge.x(0)[p], y = charge.x(1)[p];
    const std::size_t hole = scene.nearest_hole(x, y);
    double lit = scene.lighting_time(hole);
    if (c.burn == Burn::programmed)
      lit += std::hypot(x - scene.hole.x[hole] - c.x, y - scene.hole.y[hole] - c.y) / law.detonation_velocity;
    if (lit > 0) charge.store(p, law.unlit(lit));
  }
  return charge;
}

inline mpm::Body<Ugimp, mpm::PolynomialEos, Space> make_air(const Scene& scene) {
  const auto& c = scene.charge;
  if (!scene.air.fill) return {"air", {}, air_law(scene)};
  const double charge_radius = c.kind == ChargeKind::none ? 0 : c.radius;
  const double area = M_PI * (std::pow(scene.hole.radius, 2) - std::pow(charge_radius, 2));
  return fill_gas(scene, "air", air_law(scene), area, [&](double x, double y) {
    return std::hypot(x, y) < scene.hole.radius && std::hypot(x - c.x, y - c.y) >= charge_radius;
  });
}

/// The particles in the numbers of the blast.
template <class S, class Body>
auto in_space(Body body) {
  if constexpr (std::is_same_v<S, typename Body::SpaceType>) {
    return body;
  } else {
    return mpm::Body<typename Body::Shape, typename Body::Law, S>(body);
  }
}

/// Stage 2, ready to burn: the relaxed rock moves in, charge and air fill the hole, and the outer faces turn quiet,
/// holding what keeps the rock at rest. Those of a slab hold only that: a quiet face without impedance.
template <class Rock, class Integrator>
BlastSolver<Rock, Integrator> blast_stage(const Scene& scene, typename Rock::Body rock) {
  using S = typename Rock::BlastSpace;
  using Scalar = typename S::Scalar;
  // Waves reach the faces in rock under the far field, which the in-situ stress has made softer or stiffer.
  std::size_t far = 0;
  for (std::size_t p = 1; p < rock.size(); ++p)
    if (rock.x(0)[p] + rock.x(1)[p] > rock.x(0)[far] + rock.x(1)[far]) far = p;
  const double density = rock.mass()[far] / rock.volume()[far];
  const auto moduli = rock.law.tangent(rock.state(far), rock.relative_volume(far));
  rock.stress_work = rock.viscous_work = 0;
  BlastSolver<Rock, Integrator> solver(background<S>(scene), in_space<S>(std::move(rock)),
                                       in_space<S>(make_charge(scene)), in_space<S>(make_air(scene)));
  solver.safety = Scalar(scene.step.safety);
  solver.integrator.flip = scene.step.flip;
  set_faces<S>(solver, scene, [&](int, int) {
    return scene.block.faces == Faces::free
               ? mpm::Quiet<S>{}
               : mpm::Quiet<S>::from(Scalar(density),
                                     mpm::Moduli<Scalar>{Scalar(moduli.longitudinal), Scalar(moduli.shear)});
  });
  solver.hold_quiet_faces();
  if (scene.step.rest_speed > 0) solver.template let_rest<0>(Scalar(scene.step.rest_speed));
  return solver;
}

}  // namespace blasting
