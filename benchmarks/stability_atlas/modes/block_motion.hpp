// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include "../law.hpp"
#include "sampled_run.hpp"

namespace mpm::atlas {

/// Motions of a block in the plane that no stress resists, or that is rigid.
template <class Shape, class Integrator>
class BlockMotion {
 public:
  /// Simple shear to 10 without stiffness: the particles' rms distance from where they should be, over that from where
  /// they started, by shear.
  template <class F>
  static void shear_flow(const Integrator& integrator, int samples, const F& curve) {
    BlockMotion block({6, 6}, {32, 6}, {64, 12}, 1e-9, integrator);
    block.start([](const Vector<S>& X) { return Vector<S>{X[1], 0}; });
    const double rms_height = std::sqrt(143 / 48.);  // of twelve rows, half a cell each
    const auto shear = [&] { return block.solver_.time; };
    const auto error = [&] {
      const auto exact = [&](const Vector<S>& X) { return Vector<S>{X[0] + shear() * X[1], X[1]}; };
      return block.misplaced(exact) / (shear() * rms_height);
    };
    sampled_run(block.solver_, 10, samples, shear, error, curve);
  }
  /// Two turns of a stiff block of 4 cells, its rim at .02 c: rms distance from the best turned block, cells, by the
  /// angle, degrees, that a rigid one would have turned.
  template <class F>
  static void spin(const Integrator& integrator, int samples, const F& curve) {
    BlockMotion block = spinning(integrator);
    const auto lost = [&] {
      const double a = block.turned(), cosine = std::cos(a), sine = std::sin(a);
      const auto turned = [&](const Vector<S>& X) {
        return Vector<S>{cosine * X[0] - sine * X[1], sine * X[0] + cosine * X[1]};
      };
      return block.misplaced(turned);
    };
    block.run_turns(samples, lost, curve);
  }
  /// The same: share of that angle by which it has not turned.
  template <class F>
  static void turn(const Integrator& integrator, int samples, const F& curve) {
    BlockMotion block = spinning(integrator);
    double turned = 0;
    const auto lost = [&] {
      turned += std::remainder(block.turned() - turned, 2 * std::numbers::pi);
      return std::abs(turned / (spin_rate * block.solver_.time) - 1);
    };
    block.run_turns(samples, lost, curve);
  }
  /// A strip without stiffness drawn out to 20: the widest gap between neighbours in a row, in the length of their
  /// domains, by stretch. Of shapes whose particles have a length.
  template <class F>
  static void over_stretch(const Integrator& integrator, int samples, const F& curve) {
    BlockMotion block({4, 2}, {46.3, 3.2}, {92, 7}, 1e-9, integrator);
    block.start([](const Vector<S>& X) { return Vector<S>{X[0], 0}; });
    const auto stretch = [&] { return 1 + block.solver_.time; };
    const auto gap = [&] { return std::max(1e-6, block.widest_gap()); };
    sampled_run(block.solver_, 19, samples, stretch, gap, curve);
  }

 private:
  using S = PlaneStrain<>;
  using SolverT = Solver<Shape, Law, Integrator, S>;
  static constexpr double spin_rate = .02 / 2.83;  // of a corner at 2.83 cells

  /// A block of width x height unit cells about `centre`, 2 particles an edge.
  BlockMotion(const Vector<S>& size, const Vector<S>& centre, const std::array<int, 2>& cells, double young,
              const Integrator& integrator)
      : centre_(centre), solver_(make(size, centre, cells, young)) {
    solver_.integrator = integrator;
  }
  static SolverT make(const Vector<S>& size, const Vector<S>& centre, const std::array<int, 2>& cells, double young) {
    Body<Shape, Law, S> body{"block", {}, {{.density = 1, .young = young, .poisson = 0}}};
    fill(body, centre - size / 2, centre + size / 2, .5);
    return SolverT{Grid<S>{{0, 0}, 1, cells}, std::move(body)};
  }
  static BlockMotion spinning(const Integrator& integrator) {
    BlockMotion block({4, 4}, {5.3, 5.2}, {11, 11}, 1, integrator);
    block.start([](const Vector<S>& X) { return Vector<S>{-spin_rate * X[1], spin_rate * X[0]}; });
    return block;
  }
  template <class Y, class Curve>
  void run_turns(int samples, const Y& y, const Curve& curve) {
    constexpr double degree = std::numbers::pi / 180;
    const auto angle = [&] { return solver_.time * spin_rate / degree; };
    sampled_run(solver_, 720 * degree / spin_rate, samples, angle, y, curve);
  }
  /// With a velocity of the place relative to the centre.
  template <class F>
  void start(const F& velocity) {
    auto& body = solver_.body();
    for (std::size_t p = 0; p < body.size(); ++p) {
      const Vector<S> X = body.position(p) - centre_, v = velocity(X);
      for (int d = 0; d < 2; ++d) body.v(d)[p] = v[d], body.history(d)[p] = X[d];
    }
  }
  /// Root mean square distance of the particles from where `exact(X)` puts them, relative to the centre, cells.
  template <class F>
  double misplaced(const F& exact) {
    const auto& body = solver_.body();
    double sum = 0;
    for (std::size_t p = 0; p < body.size(); ++p)
      sum += (body.position(p) - centre_ - exact(problems::origin(body, p))).squaredNorm();
    return std::sqrt(sum / double(body.size()));
  }
  /// Angle by which the block has turned about its centre, the best in the sense of least squares, -pi to pi.
  double turned() {
    const auto& body = solver_.body();
    double sine = 0, cosine = 0;
    for (std::size_t p = 0; p < body.size(); ++p) {
      const Vector<S> x = body.position(p) - centre_, X = problems::origin(body, p);
      sine += X[0] * x[1] - X[1] * x[0], cosine += X.dot(x);
    }
    return std::atan2(sine, cosine);
  }
  double widest_gap() {
    const auto& body = solver_.body();
    struct End {
      double Y, X, left, right;
    };
    std::vector<End> ends;
    for (std::size_t p = 0; p < body.size(); ++p) {
      const auto [left, right] = extent(body, p);
      const auto X = problems::origin(body, p);
      ends.push_back({X[1], X[0], left, right});
    }
    std::ranges::sort(ends, [](const End& a, const End& b) { return a.Y != b.Y ? a.Y < b.Y : a.X < b.X; });
    double widest = 0;
    for (std::size_t k = 1; k < ends.size(); ++k)
      if (ends[k].Y == ends[k - 1].Y)
        widest = std::max(widest, (ends[k].left - ends[k - 1].right) / (ends[k].right - ends[k].left));
    return widest;
  }
  /// Of a particle along x.
  static std::pair<double, double> extent(const Body<Shape, Law, S>& body, std::size_t p) {
    const double x = body.x(0)[p];
    if constexpr (requires { body.shape.quad; }) {
      const auto& q = body.shape.quad[p];
      const auto at = [&](int c) { return body.shape.corner[q[std::size_t(c)]][0]; };
      return {(at(0) + at(3)) / 2, (at(1) + at(2)) / 2};
    } else if constexpr (std::is_same_v<Shape, Cpdi>) {
      const double half = body.F(p).xx * body.shape.half_size[0];
      return {x - half, x + half};
    } else {
      const double half = std::min(1.5, body.shape.reach(body, p, Grid<S>{{0, 0}, 1, {1, 1}})[0]);
      return {x - half, x + half};
    }
  }

  Vector<S> centre_;
  SolverT solver_;
};

}  // namespace mpm::atlas
