// SPDX-License-Identifier: MIT
#pragma once
#include "outcome.hpp"
#include <mpm/analysis/manufactured.hpp>
#include <mpm/geometry/annulus.hpp>
#include <mpm/mpm.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

// What runs of the manufactured solutions share: particles that know where they were, the body force that drives them,
// and the error. A solution is one of mpm/analysis/manufactured.hpp.
namespace mpm::problems {

/// A law whose particles carry their reference position X, Y, Z, m, as history that it never changes.
template <class Law>
struct WithOrigin : Law {
  template <class V>
  struct State : Law::template State<V> {
    V X{}, Y{}, Z{};
  };
  static constexpr auto history = [] {
    std::array<const char*, Law::history.size() + 3> names{};
    std::copy(Law::history.begin(), Law::history.end(), names.begin());
    names[names.size() - 3] = "X", names[names.size() - 2] = "Y", names[names.size() - 1] = "Z";
    return names;
  }();
  template <class V>
  State<V> initial() const {
    return {Law::template initial<V>(), V(0), V(0), V(0)};
  }
};

/// Reference position of particle p of a body whose law is WithOrigin.
template <class Body>
Eigen::Matrix<double, Body::dimension, 1> origin(const Body& body, std::size_t p) {
  Eigen::Matrix<double, Body::dimension, 1> X;
  for (int d = 0; d < Body::dimension; ++d) X[d] = double(body.history(Body::history_count - 3 + d)[p]);
  return X;
}

/// The body force of a manufactured solution.
template <class Solution, class S>
struct ManufacturedForce {
  Solution solution{};
  template <class Body>
  Vector<S> operator()(const Body& body, std::size_t p, double time) const {
    return solution.body_force(origin(body, p), time).template cast<typename S::Scalar>();
  }
};

/// Gives every particle, which must stand at its reference position, its place, F and stress at t = 0, and its velocity
/// half a step earlier: symplectic Euler carries velocities between the times of the positions, and would be of first
/// order if they started on them.
template <class Body, class Solution>
void start(Body& body, const Solution& solution, double dt) {
  using Scalar = typename Body::Scalar;
  constexpr int D = Body::dimension;
  const auto exact_stress = [&](const Tensor<double>& F) {
    NeoHookean::State<double> state;
    solution.material.update(state, {.F = F, .J = determinant(F)});
    return state.stress;
  };
  for (std::size_t p = 0; p < body.size(); ++p) {
    const analysis::Point<D> X = body.position(p).template cast<double>(), u = solution.displacement(X, 0);
    const analysis::Point<D> v = solution.velocity(X, -dt / 2);
    const Tensor<double> F = solution.deformation_gradient(X, 0);
    const auto s = exact_stress(F);
    auto state = body.state(p);
    state.stress = {Scalar(s.xx), Scalar(s.yy), Scalar(s.zz), Scalar(s.xy), Scalar(s.yz), Scalar(s.zx)};
    body.store(p, state);
    body.store_F(p, {Scalar(F.xx), Scalar(F.xy), Scalar(F.xz), Scalar(F.yx), Scalar(F.yy), Scalar(F.yz), Scalar(F.zx),
                     Scalar(F.zy), Scalar(F.zz)});
    body.volume()[p] *= Scalar(determinant(F));
    for (int d = 0; d < D; ++d) {
      body.history(Body::history_count - 3 + d)[p] = Scalar(X[d]);
      body.x(d)[p] = Scalar(X[d] + u[d]), body.v(d)[p] = Scalar(v[d]);
    }
  }
  if constexpr (Body::Shape::domain_motion == DomainMotion::corners) {
    for (auto& x : body.shape.corner) {
      const analysis::Point<D> u = solution.displacement({x[0], x[1]}, 0);
      x[0] += u[0], x[1] += u[1];
    }
    for (std::size_t p = 0; p < body.size(); ++p) {
      const auto x = body.shape.centroid(p);
      for (int d = 0; d < D; ++d) body.x(d)[p] = Scalar(x[d]);
      body.volume()[p] = Scalar(body.shape.weights(p).area);
    }
  }
}

/// A body of particles at rest on the quadrilaterals of a mesh: quadrilaterals themselves where the shape has corners,
/// or points and boxes of the edge `size` at their centroids, with their areas.
template <class Shape, class S, class Law>
Body<Shape, Law, S> body_on(const geometry::QuadMesh& mesh, const Law& law, double size) {
  const auto quads = geometry::make_body<S>("body", mesh, law);
  if constexpr (std::is_same_v<Shape, CpdiQuad>) {
    return quads;
  } else {
    Body<Shape, Law, S> body{"body", {}, law};
    if constexpr (requires { body.shape.half_size; }) body.shape.half_size = {size / 2, size / 2};
    for (std::size_t p = 0; p < quads.size(); ++p) body.add(quads.position(p), quads.volume()[p], {0, 0});
    return body;
  }
}

/// Runs a solver whose particles stand at their reference positions, at rest, until `end`, s. The step is that
/// of the body at rest, equal to the end: symplectic Euler with steps that change is of first order. It is shortened
/// only where the certain step has become shorter still. The error is that of the displacement, sqrt(sum abs(u -
/// u_exact)^2 / sum abs(u_exact)^2) over all particles and steps.
template <class SolverT>
Outcome run_manufactured(SolverT& solver, double end) {
  const auto solution = solver.body_force.solution;
  auto& body = solver.body();
  auto trial = solver;
  start(trial.body(), solution, 0);
  for (int d = 0; d < trial.grid.dimension; ++d) std::fill_n(trial.body().v(d), trial.body().size(), 0);
  const double dt = end / std::ceil(end / double(trial.step()));
  start(body, solution, dt);
  solver.safety = 1;
  Outcome outcome{.particles = std::int64_t(body.size()), .bytes = std::size_t(body.bytes_per_particle)};
  double error = 0, norm = 0;
  while (solver.time < end * (1 - 1e-12)) {
    const double begin = processor_seconds();
    solver.step(std::min(dt, end - solver.time));
    outcome.seconds += processor_seconds() - begin;
    for (std::size_t p = 0; p < body.size(); ++p) {
      const auto X = origin(body, p);
      const auto exact = solution.displacement(X, solver.time);
      error += (body.position(p).template cast<double>() - X - exact).squaredNorm(), norm += exact.squaredNorm();
    }
  }
  outcome.steps = solver.steps;
  outcome.error = std::sqrt(error / norm);
  return outcome;
}

}  // namespace mpm::problems
