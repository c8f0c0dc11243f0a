// SPDX-License-Identifier: MIT
#pragma once
#include "fill.hpp"
#include "law.hpp"
#include <mpm/mpm.hpp>
#include <cmath>

namespace mpm::atlas {

/// Moves the particles of a lattice that starts at the origin to where a fill wants them.
template <class Body>
class Distortion {
 public:
  using S = typename Body::SpaceType;
  static constexpr int D = S::dimension;

  Distortion(const Fill& fill, Random& random) : fill_(fill), random_(random) {
    for (int corner = 0; corner < 1 << D; ++corner) {
      Vector<S> X;
      for (int d = 0; d < D; ++d) X[d] = corner >> d & 1 ? fill.count[std::size_t(d)] / fill.per_edge : 0;
      lowest_ = lowest_.cwiseMin(turned(X)), highest_ = highest_.cwiseMax(turned(X));
    }
  }
  /// Cells of a grid from the origin that leaves two behind the fill.
  std::array<int, D> cells() const {
    std::array<int, D> n;
    for (int d = 0; d < D; ++d) n[std::size_t(d)] = int(std::ceil(moved(highest_)[d])) + 2;
    return n;
  }
  void operator()(Body& body) const {
    constexpr bool by_corners = Body::Shape::domain_motion == DomainMotion::corners;
    if constexpr (by_corners)
      for (auto& c : body.shape.corner) {
        // Before it is stretched, so that no quadrilateral turns inside out.
        const Vector<S> x = moved(turned(shifted({c[0], c[1]})));
        c = {std::abs(x[0]), std::abs(x[1])};
      }
    const Tensor<double> F = gradient();
    const double box = determinant(F) / std::pow(fill_.per_edge, D);
    for (std::size_t p = 0; p < body.size(); ++p) {
      Vector<S> x;
      if constexpr (by_corners) {
        x = {body.shape.centroid(p)[0], body.shape.centroid(p)[1]};
        body.volume()[p] = body.shape.weights(p).area;
      } else {
        x = jittered(moved(turned(body.position(p))));
        body.volume()[p] = box * (S::hoop ? x[0] : 1);
      }
      for (int d = 0; d < D; ++d) body.x(d)[p] = x[d];
      body.mass()[p] = body.volume()[p];
      if constexpr (Body::stores_F) body.store_F(p, F);
    }
  }

 private:
  Tensor<double> gradient() const {
    const auto& s = fill_.stretch;
    return {s[0], D == 2 ? fill_.shear : 0, 0, 0, D > 1 ? s[1] : 1, 0, 0, 0, D > 2 || S::hoop ? s[2] : 1};
  }
  Vector<S> turned(const Vector<S>& X) const {
    const Tensor<double> F = gradient();
    Vector<S> x = F.xx * X;
    if constexpr (D > 1) x[0] += F.xy * X[1], x[1] = F.yy * X[1];
    if constexpr (D > 2) x[2] = F.zz * X[2];
    return x;
  }
  Vector<S> moved(Vector<S> x) const {
    for (int d = 0; d < D; ++d) x[d] += fill_.margin[std::size_t(d)] + fill_.offset[std::size_t(d)] - lowest_[d];
    return x;
  }
  Vector<S> shifted(Vector<S> x) const {
    std::uniform_real_distribution<> shift(-fill_.jitter / fill_.per_edge, fill_.jitter / fill_.per_edge);
    for (int d = 0; d < D; ++d) x[d] += shift(random_);
    return x;
  }
  Vector<S> jittered(const Vector<S>& x) const { return shifted(x).cwiseAbs(); }

  const Fill& fill_;
  Random& random_;
  Vector<S> lowest_ = Vector<S>::Constant(1e9), highest_ = -lowest_;
};

/// The body of a fill at rest, and the grid that it stands in.
template <class Shape, class S>
struct FilledGrid {
  Body<Shape, Law, S> body;
  Grid<S> grid;
};
template <class Shape, class S>
FilledGrid<Shape, S> fill_grid(const Fill& f, Random& random) {
  Body<Shape, Law, S> body{"fill", {}, {{.density = 1, .young = 1, .poisson = f.poisson}}};
  const double spacing = 1 / f.per_edge;
  Vector<S> upper;
  for (int d = 0; d < S::dimension; ++d) upper[d] = spacing * f.count[std::size_t(d)];
  std::bernoulli_distribution kept(f.kept);
  fill(body, Vector<S>::Zero(), upper, spacing, [&](const Vector<S>&) { return kept(random); });
  if (body.size() == 0) fill(body, Vector<S>::Zero(), Vector<S>::Constant(spacing), spacing);
  const Distortion<Body<Shape, Law, S>> distort(f, random);
  distort(body);
  return {std::move(body), Grid<S>{Vector<S>::Zero(), 1, distort.cells()}};
}

/// Its solver, with rollers at the lower faces.
template <class Shape, class Integrator, class S>
auto fill_solver(const Fill& f, Random& random) {
  auto filled = fill_grid<Shape, S>(f, random);
  Solver<Shape, Law, Integrator, S> solver{std::move(filled.grid), std::move(filled.body)};
  for (int d = 0; d < S::dimension; ++d) solver.boundary.face(d, 0) = Rollers<S>{};
  return solver;
}

}  // namespace mpm::atlas
