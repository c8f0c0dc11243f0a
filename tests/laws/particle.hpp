// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/material.hpp>
#include <cmath>
#include <random>

namespace mpm::laws {

/// One particle driven along a path of deformation gradients, with the work done on it per initial volume.
template <class Law, class Real>
struct Particle {
  using State = typename Law::template State<Real>;

  Law law;
  State state = law.template initial<Real>();
  Tensor<Real> F = Tensor<Real>::identity();
  Real J{1}, time{};
  Real dt = Real(1e-6), size = Real(5e-3), cell = Real(1e-2);
  double work{};

  static SymmetricTensor<Real> stress_of(const State& s) {
    if constexpr (Fluid<Law>)
      return SymmetricTensor<Real>::spherical(-s.pressure);
    else
      return s.stress;
  }
  SymmetricTensor<Real> stress() const { return stress_of(state); }
  Moduli<Real> tangent() const { return law.tangent(state, J); }

  /// The step with velocity gradient `L` that ends at the deformation gradient `to`.
  void step(const Tensor<Real>& L, const Tensor<Real>& to) {
    const auto before = stress();
    const Real J_to = determinant(to), J_mean = (J + J_to) / 2;
    time += dt;
    law.update(state, {L, to, J_to, J, dt, time, size, cell});
    work += double(J_mean * dt) * double(inner(Real(0.5) * (before + stress()), symmetric(L)));
    F = to;
    J = J_to;
  }

  /// The straight step to `to`: displacement gradient about its middle, so exact in volume to third order.
  void go(const Tensor<Real>& to) {
    const auto change = to + Real(-1) * F;
    step((1 / dt) * (change * inverse(Real(0.5) * (F + to))), to);
  }

  /// Holds the deformation until nothing that lags by a step (rate factor, pressure of bulking) is left.
  void settle(int steps = 50) {
    for (int i = 0; i < steps; ++i) step({}, F);
  }

  static Tensor<Real> inverse(const Tensor<Real>& a) {
    const Tensor<Real> adjugate{a.yy * a.zz - a.yz * a.zy, a.xz * a.zy - a.xy * a.zz, a.xy * a.yz - a.xz * a.yy,
                                a.yz * a.zx - a.yx * a.zz, a.xx * a.zz - a.xz * a.zx, a.xz * a.yx - a.xx * a.yz,
                                a.yx * a.zy - a.yy * a.zx, a.xy * a.zx - a.xx * a.zy, a.xx * a.yy - a.xy * a.yx};
    return (1 / determinant(a)) * adjugate;
  }
};

/// Random numbers and tensors, the same ones on every run.
template <class Real>
struct Random {
  std::mt19937_64 engine{20240521};

  Real number(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(engine); }
  Tensor<Real> tensor(Real size) {
    const auto n = [&] { return number(-size, size); };
    return {n(), n(), n(), n(), n(), n(), n(), n(), n()};
  }
  Tensor<Real> rotation() { return step_rotation(tensor(Real(4)), Real(1)); }
};

template <class Real>
double largest(const SymmetricTensor<Real>& a) {
  return std::sqrt(double(inner(a, a)));
}

}  // namespace mpm::laws
