// SPDX-License-Identifier: MIT
#include <mpm/analysis/energy.hpp>
#include <accuracy_cost/methods.hpp>
#include <algorithm>
#include <cmath>
#include "integrators.hpp"
#include "modes/sampled_run.hpp"
#include "sheets.hpp"

namespace mpm::atlas {
namespace {

using S = PlaneStrain<>;

/// A closed box of 10 x 10 cells, a quarter of its air at 20 times the pressure.
template <class Shape, class Integrator>
class Box {
 public:
  explicit Box(const Integrator& integrator) : solver_(make()) {
    solver_.integrator = integrator;
    for (const int axis : {0, 1})
      for (const int side : {0, 1}) solver_.boundary.face(axis, side) = Rollers<S>{};
  }
  /// Change of the energy, relative, while sound would cross the box ten times.
  template <class F>
  void run(int samples, const F& curve) {
    const double crossing = 10 / std::sqrt(1.4), start = energy();
    const auto crossings = [&] { return solver_.time / crossing; };
    const auto change = [&] { return std::max(1e-6, std::abs(energy() / start - 1)); };
    sampled_run(solver_, 10 * crossing, samples, crossings, change, curve);
  }

 private:
  using SolverT = Solver<Shape, PolynomialEos, Integrator, S>;
  static SolverT make() {
    Body<Shape, PolynomialEos, S> gas{"gas", {}, {.density = 1, .c4 = .4, .c5 = .4, .initial_energy = 2.5}};
    fill(gas, {0, 0}, {10, 10}, .5);
    for (std::size_t p = 0; p < gas.size(); ++p) {
      auto state = gas.state(p);
      if (gas.x(0)[p] < 5 && gas.x(1)[p] < 5) state.energy *= 20, state.pressure *= 20;
      gas.store(p, state);
    }
    return SolverT{Grid<S>{{0, 0}, 1, {10, 10}}, std::move(gas)};
  }
  double energy() {
    const auto& gas = solver_.body();
    double sum = kinetic_energy(gas);
    for (std::size_t p = 0; p < gas.size(); ++p) sum += gas.mass()[p] / gas.law.density * gas.state(p).energy;
    return sum;
  }
  SolverT solver_;
};

}  // namespace

Sheet gas_in_a_box(bool quick) {
  Sheet sheet{"gas", "gas"};
  sheet.title = "Air in a closed box, a quarter of it at 20 times the pressure";
  sheet.x_label = "crossings of the box by sound";
  sheet.y_label = "change of energy, %";
  sheet.at = "crossing ", sheet.limit = .1, sheet.percent = 100;
  for (const char* shape : {"Cpdi", "CpdiQuad"}) sheet.refused[shape] = "refused by the compiler";
  const auto add = [&]<class Shape>() {
    for_each_integrator([&]<class Integrator>(const char* name, const Integrator& integrator) {
      Box<Shape, Integrator>(integrator).run(quick ? 10 : 40, [&](double crossings, double change) {
        sheet.points.push_back({accuracy_cost::shape_name<Shape>(), name, crossings, change});
      });
    });
  };
  add.operator()<Linear>();
  add.operator()<Ugimp>();
  add.operator()<Cpgimp>();
  add.operator()<QuadraticBspline>();
  add.operator()<CubicBspline>();
  return sheet;
}

}  // namespace mpm::atlas
