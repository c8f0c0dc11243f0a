// SPDX-License-Identifier: MIT
#pragma once
#include "linear_step.hpp"
#include <mpm/materials/elastic_moduli.hpp>
#include <mpm/solver.hpp>
#include <bit>
#include <cmath>
#include <random>

namespace mpm::atlas {

/// The linear step of a solver of one body that rests without stress. All that a step hands on must be with the body:
/// not for integrators with particle columns of their own (APIC), nor for those whose nodes keep velocities.
template <class SolverT>
class SolverStep final : public LinearStep {
 public:
  using BodyT = typename SolverT::template BodyAt<0>;
  using S = typename BodyT::SpaceType;
  static constexpr int per_particle = S::dimension + BodyT::stress_count;

  /// Takes the first step, which moves nothing but brings the particles into their order.
  explicit SolverStep(SolverT solver) : solver_(std::move(solver)) {
    certain_ = double(solver_.step()) / double(solver_.safety);
    solver_.safety = 1e9;
    rest_ = solver_.body();
  }
  double certain() const override { return certain_; }

  double nodal_limit() override {
    std::vector<Vector<S>> v(solver_.grid.size());
    std::mt19937_64 random{1};
    for (auto& node : v)
      for (double& c : node) c = std::normal_distribution<>()(random);
    solver_.body() = rest_;
    solver_.internal_forces();  // for the nodes' masses
    double square = 0;
    for (int k = 0; k < 400; ++k) {
      v = acceleration(v);
      double norm = 0;
      for (const auto& node : v) norm = std::max(norm, node.cwiseAbs().maxCoeff());
      for (auto& node : v) node /= norm;
      square = norm;
    }
    return 2 / std::sqrt(square);
  }

  Eigen::MatrixXd matrix(double dt) override {
    const int size = int(rest_.size()) * per_particle;
    Eigen::MatrixXd A(size, size);
    BodyT& body = solver_.body();
    for (int j = 0; j < size; ++j) {
      body = rest_;
      put(body, std::size_t(j / per_particle), j % per_particle, amplitude);
      solver_.step(dt);
      for (int i = 0; i < size; ++i) A(i, j) = get(body, std::size_t(i / per_particle), i % per_particle) / amplitude;
    }
    return A;
  }

 private:
  static constexpr double amplitude = 1e-12;  // products of two of them are lost in round-off

  /// M^-1 K u of a field of nodal displacements.
  std::vector<Vector<S>> acceleration(const std::vector<Vector<S>>& u) {
    std::vector<Vector<S>> f(u.size(), Vector<S>::Zero());
    const double lambda = lame_modulus(rest_.law.young, rest_.law.poisson);
    const double mu = shear_modulus(rest_.law.young, rest_.law.poisson);
    for (std::size_t p = 0; p < rest_.size(); ++p) {
      const auto stencil = make_stencil(rest_, p, solver_.grid);
      const double radius = rest_.x(0)[p];
      const auto strain = symmetric(velocity_gradient<S>(stencil, u, radius));
      const auto stress = SymmetricTensor<double>::spherical(lambda * trace(strain)) + 2 * mu * strain;
      for (const auto& [I, w, grad] : stencil) f[I] += stress_flux<S>(stress, rest_.volume()[p], radius, w, grad);
    }
    for (std::size_t n = 0; n < f.size(); ++n)
      if (solver_.grid.mass[n] > 0) f[n] /= solver_.grid.mass[n];
    solver_.boundary.constrain(f, solver_.grid);
    return f;
  }
  double scale(std::size_t p, int k) const {
    if (k < S::dimension) return std::sqrt(rest_.mass()[p]);
    return std::sqrt(rest_.volume()[p] / rest_.law.tangent(rest_.state(p), rest_.relative_volume(p)).longitudinal);
  }
  static std::size_t component(int k) { return std::size_t(S::stress_components[std::size_t(k - S::dimension)]); }
  void put(BodyT& body, std::size_t p, int k, double value) const {
    value /= scale(p, k);
    if (k < S::dimension) {
      body.v(k)[p] = value;
    } else {
      auto state = body.state(p);
      auto all = std::bit_cast<std::array<double, 6>>(state.stress);
      all[component(k)] = value;
      state.stress = std::bit_cast<SymmetricTensor<double>>(all);
      body.store(p, state);
    }
  }
  double get(const BodyT& body, std::size_t p, int k) const {
    if (k < S::dimension) return scale(p, k) * body.v(k)[p];
    return scale(p, k) * std::bit_cast<std::array<double, 6>>(body.stress(p))[component(k)];
  }

  SolverT solver_;
  BodyT rest_;
  double certain_ = 0;
};

}  // namespace mpm::atlas
