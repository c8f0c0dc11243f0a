// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/chunk_list.hpp>
#include <mpm/concepts/shape_function.hpp>
#include <mpm/shapes/cpdi.hpp>
#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace mpm {

/// CPDI2, "CPDI-Quadrilateral" (Sadeghirad, Brannon & Guilkey 2013): domains are quadrilaterals whose corners ride the
/// grid. Neighbours share their corners, so that no gap can open between them.
///
/// Corner positions are double whatever the space's scalar: in float a displacement of a nanometre would be lost.
struct CpdiQuad {
  using Point = std::array<double, 2>;
  using Quad = std::array<std::uint32_t, 4>;

  std::vector<Point> corner;  ///< positions, m
  std::vector<Quad> quad;     ///< the four corners of each particle, counter-clockwise
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      surface;          ///< free edges under `pressure`, the body on their left
  double pressure = 0;  ///< on `surface`, following it, Pa

  static constexpr DomainMotion domain_motion = DomainMotion::corners;
  static constexpr bool tangles = true;
  template <class S>
  static constexpr int max_nodes = 16;
  template <class S>
  static constexpr std::size_t bytes = sizeof(Quad) + sizeof(Point);

  /// Weights and gradients of the four corners of a quadrilateral: the averages over its area of its bilinear
  /// functions.
  struct Weights {
    double area;
    std::array<double, 4> w;
    std::array<Point, 4> gradient;
  };
  Weights weights(std::size_t p) const {
    const auto& [x1, y1] = corner[quad[p][0]];
    const auto& [x2, y2] = corner[quad[p][1]];
    const auto& [x3, y3] = corner[quad[p][2]];
    const auto& [x4, y4] = corner[quad[p][3]];
    const double V = 0.5 * ((x3 - x1) * (y4 - y2) - (x4 - x2) * (y3 - y1));
    const double a = (x4 - x1) * (y2 - y3) - (x2 - x3) * (y4 - y1);
    const double b = (x3 - x4) * (y1 - y2) - (x1 - x2) * (y3 - y4);
    const double s = 1 / (24 * V), g = 1 / (2 * V);
    return {V,
            {(6 * V - a - b) * s, (6 * V - a + b) * s, (6 * V + a + b) * s, (6 * V + a - b) * s},
            {{{(y2 - y4) * g, (x4 - x2) * g},
              {(y3 - y1) * g, (x1 - x3) * g},
              {(y4 - y2) * g, (x2 - x4) * g},
              {(y1 - y3) * g, (x3 - x1) * g}}}};
  }
  Point centroid(std::size_t p) const {
    const auto k = weights(p);
    Point x{};
    for (int c = 0; c < 4; ++c)
      for (int d = 0; d < 2; ++d) x[d] += k.w[c] * corner[quad[p][c]][d];
    return x;
  }

  template <class Body, class S, class Out>
  void stencil(const Body&, std::size_t p, const Grid<S>& grid, Out& out) const {
    static_assert(S::dimension == 2 && !S::hoop, "mpm::CpdiQuad is for two plane dimensions");
    using Scalar = typename S::Scalar;
    const auto k = weights(p);
    std::array<Cpdi::Corner<Scalar>, 4> corners;
    for (int c = 0; c < 4; ++c) {
      const Point &x = corner[quad[p][c]], &g = k.gradient[c];
      corners[c] = {{Scalar(x[0]), Scalar(x[1])}, Scalar(k.w[c]), {Scalar(g[0]), Scalar(g[1])}};
    }
    Cpdi::corners(grid, corners, out);
  }
  /// The weights of particle p on its own corners.
  template <class Out>
  void corner_stencil(std::size_t p, Out& out) const {
    using Scalar = std::remove_cvref_t<decltype(out.begin()->weight)>;
    const auto k = weights(p);
    for (int c = 0; c < 4; ++c)
      out.add(int(quad[p][c]), Scalar(k.w[c]), {Scalar(k.gradient[c][0]), Scalar(k.gradient[c][1])});
  }
  static constexpr int axis_nodes = 3;
  /// As Cpdi::domain_modes; defined beside the passes, in quad_weights.hpp.
  template <class Body, class V>
  [[gnu::always_inline]] bool domain_modes(const Body& body, std::size_t p, const Grid<typename Body::SpaceType>& grid,
                                           DomainModes<V>& out) const;
  template <class Body>
  auto reach(const Body& body, std::size_t p, const Grid<typename Body::SpaceType>&) const {
    using Scalar = typename Body::Scalar;
    std::array<Scalar, 2> r{};
    for (std::uint32_t c : quad[p])
      for (int d = 0; d < 2; ++d) r[d] = std::max(r[d], std::abs(Scalar(corner[c][d]) - body.x(d)[p]));
    return r;
  }
  template <class Body, class S>
  void check(const Body& body, const Grid<S>&) const {
    if (quad.size() != body.size())
      throw Error("body " + body.name + ": " + std::to_string(body.size()) + " particles but " +
                  std::to_string(quad.size()) + " quadrilaterals; add each particle with add_quad");
    for (std::size_t p = 0; p < quad.size(); ++p)
      if (!(weights(p).area > 0))
        throw Error("body " + body.name + ": quadrilateral " + std::to_string(p) +
                    " has no area; give its corners counter-clockwise");
  }
  void permute(std::span<const std::uint32_t> order) {
    scratch_.resize(quad.size());
    for (std::size_t i = 0; i < quad.size(); ++i) scratch_[i] = quad[order[i]];
    quad.swap(scratch_);
  }

  /// The listed corners move with their velocities; positions and volumes of the listed particles are those of their
  /// domains. Returns the first particle whose quadrilateral has lost its area, or crosses itself so far that its
  /// centroid is no longer between its corners, or body.size().
  template <class Body, class V, class Scalar>
  std::size_t convect(Body& body, const std::vector<V>& velocity, Scalar dt, const ChunkList& corners,
                      const ChunkList& particles) {
    corners.for_each_entry([&](std::size_t c) {
      for (std::size_t d = 0; d < 2; ++d) corner[c][d] += double(dt * velocity[c][Eigen::Index(d)]);
    });
    return particles.least(particles.entries(), [&](std::size_t first, int n) {
      std::size_t bad = body.size();
      for (std::size_t p = first; p < first + std::size_t(n); ++p) {
        const double area = weights(p).area;
        const auto x = centroid(p);
        if (!(area > 0) || !between_corners(p, x)) {
          bad = std::min(bad, p);
          continue;
        }
        for (int d = 0; d < 2; ++d) body.x(d)[p] = Scalar(x[std::size_t(d)]);
        body.volume()[p] = Scalar(area);
      }
      return bad;
    });
  }
  /// Calls add(corner, force) for the pressure on the free edges, with the weights of the internal force, so that a
  /// constant stress balances it exactly.
  template <class F>
  void load_surface(const F& add) const {
    for (const auto& [i, j] : surface) {
      const Point half{-0.5 * pressure * (corner[j][1] - corner[i][1]), 0.5 * pressure * (corner[j][0] - corner[i][0])};
      add(i, half);
      add(j, half);
    }
  }

 private:
  bool between_corners(std::size_t p, const Point& x) const {
    bool between = true;
    for (int d = 0; d < 2; ++d) {
      const auto [low, high] =
          std::minmax({corner[quad[p][0]][d], corner[quad[p][1]][d], corner[quad[p][2]][d], corner[quad[p][3]][d]});
      between = between && low <= x[d] && x[d] <= high;
    }
    return between;
  }

  std::vector<Quad> scratch_;
};

static_assert(ShapeFunction<CpdiQuad>);

/// Appends a quadrilateral with corners `q` of body.shape to the body, at relative volume J.
template <class Body>
void add_quad(Body& body, const CpdiQuad::Quad& q, typename Body::Scalar J = 1) {
  using Scalar = typename Body::Scalar;
  body.shape.quad.push_back(q);
  const std::size_t p = body.shape.quad.size() - 1;
  const auto x = body.shape.centroid(p);
  body.add({Scalar(x[0]), Scalar(x[1])}, Scalar(body.shape.weights(p).area), {0, 0}, J);
}

}  // namespace mpm
