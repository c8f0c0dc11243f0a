// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/mpm.hpp>
#include <cmath>
#include <numbers>

namespace mpm::atlas {

/// What a relaxation came to.
struct Rest {
  double error = 0;  ///< of the mean stress in the load, signed
  std::int64_t steps = 0;
};

/// A bar of 20 cells, held at one end and pulled at the other, from no stress at all; damping in shares of the critical
/// one, where it is fixed.
template <class Shape, Damping How>
class RelaxedBar {
 public:
  explicit RelaxedBar(double share_of_critical = 1) : solver_(bar()) {
    solver_.boundary.face(0, 0) = Rollers<S>{};
    solver_.boundary.face(0, 1) = Traction<S>::on(solver_.grid, 0, 1, [](const auto&) { return Vector<S>{pull}; });
    solver_.integrator.frequency = share_of_critical * 2 * std::numbers::pi / 4;  // wave speed 1, unit length
  }
  /// Once the kinetic energy alone has fallen to a thousandth of the elastic one (Eq 31 of Xiao et al. 2024).
  Rest when_slow() {
    do solver_.step();
    while (solver_.steps < 20 || solver_.integrator.kinetic > 1e-3 * detail::elastic_energy_scale(solver_));
    return {error(), solver_.steps};
  }
  /// By mpm::relax.
  Rest at_rest() {
    const auto steps = relax(solver_, {.tolerance = 1e-4, .check_every = 1}).steps;
    return {error(), steps};
  }

 private:
  using S = Uniaxial<>;
  using SolverT = Solver<Shape, Hypoelastic, DynamicRelaxation<How>, S>;
  static constexpr int cells = 20;
  static constexpr double pull = 1;

  static SolverT bar() {
    Body<Shape, Hypoelastic, S> body{"bar", {}, {.density = 1e6, .young = 1e6, .poisson = 0}};
    fill(body, Vector<S>{0.0}, Vector<S>{1.0}, .5 / cells);
    return SolverT{Grid<S>{Vector<S>{0.0}, 1. / cells, {cells}}, std::move(body)};
  }
  double error() {
    const auto& body = solver_.body();
    double mean = 0;
    for (std::size_t p = 0; p < body.size(); ++p) mean += body.stress(p).xx / double(body.size());
    return mean / pull - 1;
  }

  SolverT solver_;
};

}  // namespace mpm::atlas
