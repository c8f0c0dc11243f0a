// SPDX-License-Identifier: MIT
#pragma once
#include "resting_step.hpp"
#include <mpm/materials/elastic_moduli.hpp>
#include <mpm/solver.hpp>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace mpm::atlas {

/// The numbers that a linear step maps, of particles at rest without stress: velocities and stresses, each scaled so
/// that its square is an energy.
template <class BodyT>
class RestingParticles {
 public:
  using S = typename BodyT::SpaceType;
  static constexpr int per_particle = S::dimension + BodyT::stress_count;

  explicit RestingParticles(const BodyT& resting) : body(resting) {}
  int size() const { return int(body.size()) * per_particle; }
  /// Number i of `moving`, the same particles at another time.
  void put(BodyT& moving, int i, double value) const {
    const auto [p, k] = place(i);
    value /= scale(p, k);
    if (k < S::dimension) {
      moving.v(k)[p] = value;
    } else {
      auto state = moving.state(p);
      auto all = std::bit_cast<std::array<double, 6>>(state.stress);
      all[component(k)] = value;
      state.stress = std::bit_cast<SymmetricTensor<double>>(all);
      moving.store(p, state);
    }
  }
  double get(const BodyT& moving, int i) const {
    const auto [p, k] = place(i);
    if (k < S::dimension) return scale(p, k) * moving.v(k)[p];
    return scale(p, k) * std::bit_cast<std::array<double, 6>>(moving.stress(p))[component(k)];
  }
  double norm(const BodyT& moving) const {
    double sum = 0;
    for (int i = 0; i < size(); ++i) sum += std::pow(get(moving, i), 2);
    return std::sqrt(sum);
  }
  /// 2/w of the fastest mode of the nodes, of the masses that stand on the grid, by the power method.
  double nodal_limit(const Grid<S>& grid, Box<S>& boundary) const {
    std::vector<Vector<S>> v(grid.size());
    std::mt19937_64 random{1};
    for (auto& node : v)
      for (double& c : node) c = std::normal_distribution<>()(random);
    double square = 0;
    for (int k = 0; k < 400; ++k) {
      v = acceleration(v, grid, boundary);
      double norm = 0;
      for (const auto& node : v) norm = std::max(norm, node.cwiseAbs().maxCoeff());
      for (auto& node : v) node /= norm;
      square = norm;
    }
    return 2 / std::sqrt(square);
  }

  const BodyT body;

 private:
  struct Place {
    std::size_t p;
    int k;
  };
  static Place place(int i) { return {std::size_t(i / per_particle), i % per_particle}; }
  static std::size_t component(int k) { return std::size_t(S::stress_components[std::size_t(k - S::dimension)]); }
  double scale(std::size_t p, int k) const {
    if (k < S::dimension) return std::sqrt(body.mass()[p]);
    return std::sqrt(body.volume()[p] / body.law.tangent(body.state(p), body.relative_volume(p)).longitudinal);
  }
  /// M^-1 K u of a field of nodal displacements.
  std::vector<Vector<S>> acceleration(const std::vector<Vector<S>>& u, const Grid<S>& grid, Box<S>& boundary) const {
    std::vector<Vector<S>> f(u.size(), Vector<S>::Zero());
    const double lambda = lame_modulus(body.law.young, body.law.poisson);
    const double mu = shear_modulus(body.law.young, body.law.poisson);
    for (std::size_t p = 0; p < body.size(); ++p) {
      const auto stencil = make_stencil(body, p, grid);
      const double radius = body.x(0)[p];
      const auto strain = symmetric(velocity_gradient<S>(stencil, u, radius));
      const auto stress = SymmetricTensor<double>::spherical(lambda * trace(strain)) + 2 * mu * strain;
      for (const auto& [I, w, grad] : stencil) f[I] += stress_flux<S>(stress, body.volume()[p], radius, w, grad);
    }
    for (std::size_t n = 0; n < f.size(); ++n)
      if (grid.mass[n] > 0) f[n] /= grid.mass[n];
    boundary.constrain(f, grid);
    return f;
  }
};

/// The step of a solver of one body that rests without stress.
template <class SolverT>
class SolverStep final : public RestingStep {
 public:
  using BodyT = typename SolverT::template BodyAt<0>;

  explicit SolverStep(const SolverT& solver)
      : fresh_(solver), solver_(solver), certain_(certain_step()), rest_(solver_.body()) {}
  double certain() const override { return certain_; }
  double irons() const override { return irons_; }

  double nodal_limit() override {
    solver_.body() = rest_.body;
    solver_.internal_forces();  // for the nodes' masses
    return rest_.nodal_limit(solver_.grid, solver_.boundary);
  }

  double growth_rate(double dt, int steps) override {
    constexpr int between = 5;
    BodyT& body = start_anew();
    std::mt19937_64 random{1};
    for (int i = 0; i < rest_.size(); ++i) rest_.put(body, i, 1e-100 * std::normal_distribution<>()(random));
    std::vector<double> norms;
    try {
      for (int k = 0; k < steps; ++k) {
        solver_.step(dt);
        if (k % between == 0) norms.push_back(rest_.norm(body));
        if (!(norms.back() < 1e-12 && norms.back() > 0)) break;
      }
    } catch (const Error&) {
      return std::numeric_limits<double>::infinity();
    }
    const std::size_t last = norms.size() - 1, half = last / 2;
    return norms[last] > 0 ? std::pow(norms[last] / norms[half], 1. / (between * double(last - half))) : 0;
  }
  Eigen::MatrixXd matrix(double dt) override {
    constexpr double amplitude = 1e-12;  // products of two of them are lost in round-off
    const int size = rest_.size();
    Eigen::MatrixXd A(size, size);
    BodyT& body = start_anew();
    for (int j = 0; j < size; ++j) {
      body = rest_.body;
      rest_.put(body, j, amplitude);
      solver_.step(dt);
      for (int i = 0; i < size; ++i) A(i, j) = rest_.get(body, i) / amplitude;
    }
    return A;
  }

 private:
  /// A solver whose forces act for the whole of its first step.
  BodyT& start_anew() {
    solver_ = fresh_;
    return solver_.body() = rest_.body;
  }

  /// Of steps that move nothing, the longest after the first: that of a body which has been calm for a while. Those
  /// after it are as long as they are asked to be.
  double certain_step() {
    constexpr int steps = Foreseeable<BodyT> ? CalmStiffness<BodyT>::calm_steps + 2 : 1;
    irons_ = double(solver_.step()) / double(solver_.safety);
    double longest = 0;
    for (int k = 0; k < steps; ++k) longest = std::max(longest, double(solver_.step()));
    const double certain = longest / double(solver_.safety);
    fresh_.safety = 1e9;
    return certain;
  }

  SolverT fresh_, solver_;
  double irons_ = 0, certain_;
  RestingParticles<BodyT> rest_;
};

}  // namespace mpm::atlas
