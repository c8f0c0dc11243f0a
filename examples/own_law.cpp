// SPDX-License-Identifier: MIT
// A law of one's own: von Mises plasticity, and a copper cylinder that hits a rigid wall with it (Taylor 1948).
#include <mpm/mpm.hpp>
#include <algorithm>
#include <cstdio>

/// Isotropic plasticity with linear hardening on top of the rate-linear elasticity that the framework has.
struct VonMises : mpm::Hypoelastic {
  double yield = 400e6, hardening = 100e6;  ///< Pa

  template <class V>
  struct State {
    mpm::SymmetricTensor<V> stress{};  ///< Cauchy stress, Pa
    V plastic_strain{};                ///< accumulated, equivalent
  };
  static constexpr std::array history{"plastic_strain"};

  template <class V>
  State<V> initial() const {
    return {};
  }

  template <class V>
  void update(State<V>& s, const mpm::Increment<V>& step) const {
    mpm::Hypoelastic::State<V> trial{s.stress};
    mpm::Hypoelastic::update(trial, step);
    const V three_G(3 * mpm::shear_modulus(young, poisson));
    const V q = mpm::equivalent_stress(trial.stress);
    const V beyond = mpm::max(q - V(yield) - V(hardening) * s.plastic_strain, V(0));
    const V flow = beyond / (three_G + V(hardening));
    s.stress = trial.stress - (three_G * flow / mpm::max(q, V(yield))) * mpm::deviator(trial.stress);
    s.plastic_strain += flow;
  }

  template <class V>
  mpm::Moduli<V> tangent(const State<V>& s, const V& J) const {
    return mpm::Hypoelastic::tangent(mpm::Hypoelastic::State<V>{s.stress}, J);
  }
};

inline VonMises copper() {
  return {{.density = 8930, .young = 117e9, .poisson = .35}, 400e6, 100e6};
}

int main() {
  using Space = mpm::Axisymmetric<>;
  const double spacing = .4e-3;
  mpm::Body<mpm::Cpgimp, VonMises, Space> bar{"bar", {}, copper()};
  mpm::fill(bar, {0, 0}, {3.2e-3, 32.4e-3}, spacing, [](const auto&) { return true; }, {0, -227});

  mpm::Solver<mpm::Cpgimp, VonMises, mpm::Musl, Space> solver{mpm::Grid<Space>{{0, 0}, 2 * spacing, {16, 44}}, bar};
  solver.boundary.face(0, 0) = mpm::Rollers<Space>{};  // the axis
  solver.boundary.face(1, 0) = mpm::Rollers<Space>{};  // the wall
  solver.run(80e-6);

  const auto& after = solver.body();
  const double radius = *std::max_element(after.x(0), after.x(0) + after.size()) + spacing / 2;
  const double length = *std::max_element(after.x(1), after.x(1) + after.size()) + spacing / 2;
  const double strain = *std::max_element(after.history(0), after.history(0) + after.size());
  std::printf("after %.0f us: length %.2f mm, foot radius %.2f mm, largest plastic strain %.2f\n", 1e6 * solver.time,
              1e3 * length, 1e3 * radius, strain);
}
