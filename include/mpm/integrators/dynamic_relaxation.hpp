// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/integrator.hpp>
#include <mpm/grid.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

namespace mpm {

enum class Damping {
  adaptive,  ///< critical for the motion at hand (Underwood 1983; Kilic & Madenci 2010)
  fixed      ///< critical for the given lowest frequency
};

/// Dynamic relaxation to the static state: v+ = (1 - b)/(1 + b) v- + dt f / m / (1 + b) (Eq 29, 30 of Xiao et al. 2024
/// with the undamped acceleration f/m).
///
/// The nodes keep their velocities and the particles have none: what is not remapped is not smoothed, and it converges
/// in a third of the steps.
template <Damping How = Damping::adaptive>
struct DynamicRelaxation {
  double frequency = 0;  ///< lowest circular frequency, rad/s, for fixed damping; about pi c_p / (2 L)

  static constexpr StressUpdate stress_update = StressUpdate::last;
  static constexpr bool keeps_node_velocity = true;
  static constexpr int step_interval = 50;

  double damping = 0;     ///< b of the last step
  double force_norm = 0;  ///< norm of the unbalanced nodal forces of the last step, N
  double kinetic = 0;     ///< kinetic energy of the nodes in the last step, J

  template <class S>
  void advance(Grid<S>& grid, typename S::Scalar dt) {
    using Scalar = typename S::Scalar;
    acceleration_.resize(grid.size() * S::dimension);
    displacement_.resize(grid.size() * S::dimension);
    mass_.resize(grid.size());
    keep_momentum(grid);
    force_norm = std::sqrt(grid.sum_active([&](int n) { return grid.increment[n].squaredNorm(); }));
    damping = coefficient(grid, double(dt));
    const Scalar keep = Scalar((1 - damping) / (1 + damping)), add = Scalar(1 / (1 + damping));
    grid.for_each_active([&](int n) {
      if (!(grid.mass[n] > 0)) return;
      const Vector<S> a = grid.increment[n] / grid.mass[n];
      const Vector<S> v = keep * grid.velocity[n] + add * dt * a;
      for (int d = 0; d < S::dimension; ++d) {
        acceleration_[slot<S>(n, d)] = double(a[d]);
        displacement_[slot<S>(n, d)] += double(dt * v[d]);
      }
      grid.increment[n] = v - grid.velocity[n];
      grid.velocity[n] = v;
    });
    kinetic = 0.5 * grid.sum_active([&](int n) { return grid.mass[n] * grid.velocity[n].squaredNorm(); });
  }

 private:
  /// A node that particles come nearer to keeps its momentum where its velocity would make more of it: one that they
  /// barely touched may have been very fast.
  template <class S>
  void keep_momentum(Grid<S>& grid) {
    grid.for_each_active([&](int n) {
      const double mass = double(grid.mass[n]);
      if (mass > mass_[std::size_t(n)]) grid.velocity[n] *= typename S::Scalar(mass_[std::size_t(n)] / mass);
      mass_[std::size_t(n)] = mass;
    });
  }
  template <class S>
  static std::size_t slot(int node, int d) {
    return std::size_t(node) * S::dimension + std::size_t(d);
  }
  /// b = c dt / 2. Fixed: critical for `frequency`, O sqrt(1 - O^2/4), O = w dt. Adaptive: c = 2 sqrt(u K u / u M u)
  /// with the diagonal stiffness m k, k = -(a_n - a_(n-1)) / (dt v), where it is positive.
  template <class S>
  double coefficient(const Grid<S>& grid, double dt) const {
    if constexpr (How == Damping::fixed) {
      const double O = std::min(frequency * dt, 1.0);
      return O * std::sqrt(1 - O * O / 4);
    } else {
      const auto sum = [&](const auto& term) {
        return grid.sum_active([&](int n) {
          double total = 0;
          if (grid.mass[n] > 0)
            for (int d = 0; d < S::dimension; ++d) total += term(n, d, displacement_[slot<S>(n, d)]);
          return total;
        });
      };
      const double uKu = sum([&](int n, int d, double u) {
        const double a = double(grid.increment[n][d] / grid.mass[n]), v = double(grid.velocity[n][d]);
        const bool moves = std::abs(dt * v) >= std::numeric_limits<double>::min();  // over less is no finite number
        const double k = moves ? -(a - acceleration_[slot<S>(n, d)]) / (dt * v) : 0;
        return std::max(k, 0.0) * double(grid.mass[n]) * u * u;
      });
      const double uMu = sum([&](int n, int, double u) { return double(grid.mass[n]) * u * u; });
      return uMu > 0 ? std::min(std::sqrt(uKu / uMu) * dt, 0.95) : 0;
    }
  }

  std::vector<double> acceleration_, displacement_, mass_;
};

static_assert(Integrator<DynamicRelaxation<>> && Integrator<DynamicRelaxation<Damping::fixed>>);

}  // namespace mpm
