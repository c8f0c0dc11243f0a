// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/boundaries/rollers.hpp>

namespace mpm {

/// Non-reflecting face (Lysmer & Kuhlemeyer 1969), carrying the load it held when it turned quiet:
/// f = R0 - A [rho c_p n n + rho c_s (1 - n n)] v at the nodes a body has reached, solved implicitly at each, so that
/// it never limits the step.
///
/// Without the held reactions R0 a dashpot cannot carry a static load, and an in-situ stress is lost.
template <Space S>
struct Quiet : Free<S> {
  using Scalar = typename S::Scalar;

  Scalar normal_impedance = 0;      ///< rho c_p, Pa s/m
  Scalar tangential_impedance = 0;  ///< rho c_s, Pa s/m
  std::vector<Vector<S>> reaction;  ///< R0 in the order of the face's nodes, N; empty: none

  /// For an isotropic solid: impedances from its density and moduli.
  static Quiet from(Scalar density, const Moduli<Scalar>& moduli) {
    Quiet result;
    result.normal_impedance = std::sqrt(density * moduli.longitudinal);
    result.tangential_impedance = std::sqrt(density * moduli.shear);
    return result;
  }
  void load(Grid<S>& grid, int axis, int side) const {
    if (reaction.empty()) return;
    std::size_t k = 0;
    grid.for_each_on_face(axis, side, [&](int node, const auto&) {
      const std::size_t at = k++;
      if (grid.mass[node] > 0) grid.increment[node] += reaction[at];
    });
  }
  void absorb(Grid<S>& grid, int axis, int side, Scalar dt) {
    std::size_t k = 0;
    grid.for_each_on_face(axis, side, [&](int node, const auto& index) {
      const std::size_t at = k++;
      if (!(grid.mass[node] > 0)) return;
      const Scalar area = tributary_area(grid, axis, index);
      for (int d = 0; d < S::dimension; ++d) {
        const Scalar c = area * (d == axis ? normal_impedance : tangential_impedance);
        const Scalar damped = grid.velocity[node][d] * grid.mass[node] / (grid.mass[node] + dt * c);
        grid.increment[node][d] += damped - grid.velocity[node][d];
        grid.velocity[node][d] = damped;
        const Scalar force = (reaction.empty() ? 0 : reaction[at][d]) - c * damped;
        this->work += double(dt * force * (damped - Scalar(0.5) * grid.increment[node][d]));
      }
    });
  }
};

}  // namespace mpm
