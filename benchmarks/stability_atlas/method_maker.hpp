// SPDX-License-Identifier: MIT
#pragma once
#include <accuracy_cost/methods.hpp>
#include "fill_solver.hpp"
#include "integrators.hpp"
#include "method.hpp"
#include "modes/block_motion.hpp"
#include "modes/checkerboard.hpp"
#include "modes/struck_bar.hpp"
#include "solver_step.hpp"

namespace mpm::atlas {

/// Growth of a random state of a solver at rest in so many of its own steps: the largest norm over the first, the norm
/// as that of RestingStep.
template <class SolverT>
double run_growth(SolverT solver, Random& random, int steps) {
  constexpr double amplitude = 1e-12;
  auto& body = solver.body();
  using S = typename std::remove_cvref_t<decltype(body)>::SpaceType;
  std::normal_distribution<> any(0, amplitude);
  for (std::size_t p = 0; p < body.size(); ++p) {
    for (int d = 0; d < S::dimension; ++d) body.v(d)[p] = any(random);
    auto state = body.state(p);
    state.stress = {.xx = any(random), .yy = any(random), .zz = any(random)};
    body.store(p, state);
  }
  const auto norm = [&] {
    double sum = 0;
    for (std::size_t p = 0; p < body.size(); ++p) {
      const auto s = body.stress(p);
      const double M = body.law.tangent(body.state(p), body.relative_volume(p)).longitudinal;
      sum += body.mass()[p] * body.velocity(p).squaredNorm() + body.volume()[p] * inner(s, s) / M;
    }
    return std::sqrt(sum);
  };
  const double first = norm();
  double largest = first;
  for (int k = 0; k < steps && largest < 1e6 * first; ++k) {
    solver.step();
    largest = std::max(largest, norm());
  }
  return largest / first;
}

/// The methods of one space.
template <class S>
class MethodMaker {
 public:
  explicit MethodMaker(const char* space) : space_(space) {}

  /// A shape with every integrator and transfer.
  template <class Shape>
  MethodMaker& shape() {
    for_each_integrator([&](const char* name, const auto& integrator) { add<Shape>(name, integrator); });
    return add<Shape>("relaxation", DynamicRelaxation<>{});
  }
  /// A shape with the three times of the stress update.
  template <class Shape>
  MethodMaker& explicit_only() {
    add<Shape>("USF", Usf{});
    add<Shape>("USL", Usl{});
    return add<Shape>("MUSL", Musl{});
  }
  std::vector<Method> take() { return std::move(made_); }

 private:
  template <class Shape, class Integrator>
  MethodMaker& add(const char* name, const Integrator& integrator) {
    const auto solver = [integrator](const Fill& fill, Random& random) {
      auto made = fill_solver<Shape, Integrator, S>(fill, random);
      made.integrator = integrator;
      return made;
    };
    constexpr bool has_matrix = particle_columns<Integrator, S> == 0 && !Integrator::keeps_node_velocity;
    Method method{accuracy_cost::shape_name<Shape>(), name, space_, S::dimension, has_matrix};
    method.run = [solver](const Fill& fill, Random& random, int steps) {
      return run_growth(solver(fill, random), random, steps);
    };
    method.at_rest = [solver](const Fill& fill, Random& random) -> std::unique_ptr<RestingStep> {
      return std::make_unique<SolverStep<decltype(solver(fill, random))>>(solver(fill, random));
    };
    if constexpr (!Integrator::keeps_node_velocity) {
      if constexpr (std::is_same_v<S, Uniaxial<>>) add_line_modes<Shape>(method, integrator);
      if constexpr (std::is_same_v<S, PlaneStrain<>>) add_plane_modes<Shape>(method, integrator);
    }
    made_.push_back(std::move(method));
    return *this;
  }
  template <class Shape, class Integrator>
  static void add_line_modes(Method& method, const Integrator& integrator) {
    method.modes["energy"] = [integrator](bool quick, const Curve& curve) {
      double next = 0;
      struck_bar<Shape>(integrator, quick ? 10 : 20, [&](double periods, double change) {
        if (periods < next) return;
        curve(periods, std::abs(change));
        next += .25;
      });
    };
    method.modes["checkerboard"] = [integrator](bool, const Curve& curve) {
      checkerboard<Shape>(integrator, [&](int step, double share) {
        if (step % 50 == 0 || step < 5) curve(step, std::max(share, 1e-30));
      });
    };
  }
  template <class Shape, class Integrator>
  static void add_plane_modes(Method& method, const Integrator& integrator) {
    using Motion = BlockMotion<Shape, Integrator>;
    method.modes["shear"] = [integrator](bool quick, const Curve& curve) {
      Motion::shear_flow(integrator, quick ? 10 : 40, curve);
    };
    method.modes["spin"] = [integrator](bool quick, const Curve& curve) {
      Motion::spin(integrator, quick ? 8 : 24, curve);
    };
    method.modes["turn"] = [integrator](bool quick, const Curve& curve) {
      Motion::turn(integrator, quick ? 8 : 24, curve);
    };
    constexpr bool points =
        std::is_same_v<Shape, Linear> || std::is_same_v<Shape, QuadraticBspline> || std::is_same_v<Shape, CubicBspline>;
    if constexpr (!points)
      method.modes["over_stretch"] = [integrator](bool quick, const Curve& curve) {
        Motion::over_stretch(integrator, quick ? 19 : 76, curve);
      };
  }

  const char* space_;
  std::vector<Method> made_;
};

}  // namespace mpm::atlas
