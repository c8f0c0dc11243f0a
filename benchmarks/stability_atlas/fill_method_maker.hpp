// SPDX-License-Identifier: MIT
#pragma once
#include <accuracy_cost/methods.hpp>
#include "fill_method.hpp"
#include "fill_solver.hpp"
#include "solver_step.hpp"

namespace mpm::atlas {

/// Growth of a random state of a solver at rest in so many of its own steps: the largest norm over the first, the norm
/// as that of LinearStep.
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

/// The fill methods of one space.
template <class S>
class FillMethodMaker {
 public:
  explicit FillMethodMaker(const char* space) : space_(space) {}

  /// A shape with one integrator.
  template <class Shape, class Integrator>
  FillMethodMaker& add(const char* name, const Integrator& integrator) {
    const auto solver = [integrator](const Fill& fill, Random& random) {
      auto made = fill_solver<Shape, Integrator, S>(fill, random);
      made.integrator = integrator;
      return made;
    };
    FillMethod method{accuracy_cost::shape_name<Shape>(), name, space_, S::dimension};
    method.run = [solver](const Fill& fill, Random& random, int steps) {
      return run_growth(solver(fill, random), random, steps);
    };
    if constexpr (particle_columns<Integrator, S> == 0 && !Integrator::keeps_node_velocity)
      method.linear = [solver](const Fill& fill, Random& random) -> std::unique_ptr<LinearStep> {
        return std::make_unique<SolverStep<decltype(solver(fill, random))>>(solver(fill, random));
      };
    made_.push_back(std::move(method));
    return *this;
  }
  /// A shape with every integrator.
  template <class Shape>
  FillMethodMaker& shape() {
    explicit_only<Shape>();
    add<Shape>("FMPM(2)", Fmpm{.order = 2});
    add<Shape>("full-mass FLIP(2)", FullMassFlip{.order = 2});
    return add<Shape>("APIC", Apic{});
  }
  /// A shape with the three times of the stress update.
  template <class Shape>
  FillMethodMaker& explicit_only() {
    add<Shape>("USF", Usf{});
    add<Shape>("USL", Usl{});
    return add<Shape>("MUSL", Musl{});
  }
  std::vector<FillMethod> take() { return std::move(made_); }

 private:
  const char* space_;
  std::vector<FillMethod> made_;
};

}  // namespace mpm::atlas
