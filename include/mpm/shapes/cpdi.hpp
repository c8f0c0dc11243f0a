// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/shape_function.hpp>
#include <mpm/shapes/modes.hpp>
#include <mpm/shapes/tensor_product.hpp>
#include <utility>
#include <limits>

namespace mpm {

/// CPDI, the parallelogram of Sadeghirad, Brannon & Burghardt (2011), "R4": half edges r_k = F r_k0, the grid's hats
/// interpolated between the four corners. In one dimension a segment.
struct Cpdi {
  std::array<double, 3> half_size{};  ///< initial half edges of every particle's domain, m

  static constexpr DomainMotion domain_motion = DomainMotion::deformation_gradient;
  static constexpr bool tangles = true;
  template <class S>
  static constexpr int max_nodes = S::dimension == 1 ? 4 : 16;
  template <class S>
  static constexpr std::size_t bytes = 0;

  template <class Body, class S, class Out>
  void stencil(const Body& body, std::size_t p, const Grid<S>& grid, Out& out) const {
    using Scalar = typename S::Scalar;
    static_assert(S::dimension < 3, "mpm::Cpdi is for one and two dimensions; take mpm::Cpgimp in three");
    const auto F = body.F(p);
    if constexpr (S::dimension == 1) {
      const Scalar r = F.xx * Scalar(half_size[0]), x = body.x(0)[p];
      ends(grid, x - r, x + r, 1 / (2 * r), out);
    } else {
      const Scalar l0 = Scalar(half_size[0]), l1 = Scalar(half_size[1]), x = body.x(0)[p], y = body.x(1)[p];
      const Scalar ax = F.xx * l0, ay = F.yx * l0, bx = F.xy * l1, by = F.yy * l1;
      const Scalar scale = 1 / (4 * (ax * by - ay * bx)), quarter = Scalar(0.25);
      const std::array<Scalar, 2> g1{(ay - by) * scale, (bx - ax) * scale}, g2{(ay + by) * scale, -(ax + bx) * scale};
      corners(grid,
              {{{{x - ax - bx, y - ay - by}, quarter, g1},
                {{x + ax - bx, y + ay - by}, quarter, g2},
                {{x + ax + bx, y + ay + by}, quarter, {-g1[0], -g1[1]}},
                {{x - ax + bx, y - ay + by}, quarter, {-g2[0], -g2[1]}}}},
              out);
    }
  }
  template <class Body>
  auto reach(const Body& body, std::size_t p, const Grid<typename Body::SpaceType>&) const {
    using Scalar = typename Body::Scalar;
    const auto F = body.F(p);
    const Scalar l0 = Scalar(half_size[0]);
    if constexpr (Body::dimension == 1) {
      return std::array<Scalar, 1>{F.xx * l0};
    } else {
      const Scalar l1 = Scalar(half_size[1]);
      return std::array<Scalar, 2>{std::abs(F.xx) * l0 + std::abs(F.xy) * l1,
                                   std::abs(F.yx) * l0 + std::abs(F.yy) * l1};
    }
  }
  static constexpr int axis_nodes = 3;
  /// On a line. Serves segments whose ends lie within a cell of the centre's nearest node.
  template <class Body, class V>
  [[gnu::always_inline]] bool modes(const Body& body, std::size_t p, const Grid<typename Body::SpaceType>& grid,
                                    const std::array<V, 1>& xi, std::array<AxisModes<V, 3>, 1>& out) const {
    const V l = body.template F<V>(p).xx * V(half_size[0] * double(grid.inverse_cell())), half(0.5);
    auto& [anchor, weight, slope] = out[0];
    anchor = truncated(xi[0] + half);
    const V last(grid.cells(0));
    const auto a = hats(max(V(0), xi[0] - l), anchor), b = hats(min(last, xi[0] + l), anchor);
    for (std::size_t k = 0; k < 2; ++k) {
      weight[k] = half * (a.w[k] + b.w[k]);
      slope[k] = (b.w[k] - a.w[k]) * half / l;
    }
    return a.near && b.near;
  }
  /// In the plane. Serves domains whose corners lie within a cell of the centre's nearest node; `stencil` serves all.
  template <class Body, class V>
  [[gnu::always_inline]] bool domain_modes(const Body& body, std::size_t p, const Grid<typename Body::SpaceType>& grid,
                                           DomainModes<V>& out) const {
    const auto F = body.template F<V>(p);
    const V l0(half_size[0]), l1(half_size[1]), x = V::load(body.x(0) + p), y = V::load(body.x(1) + p);
    const V ax = F.xx * l0, ay = F.yx * l0, bx = F.xy * l1, by = F.yy * l1;
    const V scale = V(grid.cell()) / (V(4) * (ax * by - ay * bx));
    const V g1[2] = {(ay - by) * scale, (bx - ax) * scale}, g2[2] = {(ay + by) * scale, -(ax + bx) * scale};
    const V quarter(0.25), w[4] = {quarter, quarter, quarter, quarter};
    const V cx[4] = {x - ax - bx, x + ax - bx, x + ax + bx, x - ax + bx};
    const V cy[4] = {y - ay - by, y + ay - by, y + ay + by, y - ay + by};
    return modes_of_corners(grid, x, y, cx, cy, w, g1, g2, out);
  }
  /// Modes of a domain about (x, y) with the corners (cx, cy), their weights, and the gradients by cell of the first
  /// two; those of the others are their negatives. Returns whether modes serve all lanes.
  template <class V, class S>
  [[gnu::always_inline]] static bool modes_of_corners(const Grid<S>& grid, const V& x, const V& y, const V* cx,
                                                      const V* cy, const V* w, const V* g1, const V* g2,
                                                      DomainModes<V>& out) {
    for (int d = 0; d < 2; ++d) out.anchor[d] = truncated(coordinate(grid, d, d == 0 ? x : y) + V(0.5));
    Hats<V> a[4], b[4];
    bool near = true;
    for (int c = 0; c < 4; ++c) {
      a[c] = hats(coordinate(grid, 0, cx[c]), out.anchor[0]), b[c] = hats(coordinate(grid, 1, cy[c]), out.anchor[1]);
      near = near && a[c].near && b[c].near;
    }
    out.weight[0] = V(1);
    out.slope[0][0] = out.slope[1][0] = V(0);
    shapes::unrolled<8>([&](auto m) __attribute__((always_inline)) {
      constexpr int k = m + 1, i = k % 3, j = k / 3;
      V part[4];
      for (int c = 0; c < 4; ++c) {
        if constexpr (i == 0) {
          part[c] = b[c].w[j - 1];
        } else if constexpr (j == 0) {
          part[c] = a[c].w[i - 1];
        } else {
          part[c] = a[c].w[i - 1] * b[c].w[j - 1];
        }
      }
      out.weight[k] = (w[0] * part[0] + w[1] * part[1]) + (w[2] * part[2] + w[3] * part[3]);
      for (int d = 0; d < 2; ++d) out.slope[d][k] = g1[d] * (part[0] - part[2]) + g2[d] * (part[1] - part[3]);
    });
    return near;
  }
  template <class Body, class S>
  void check(const Body& body, const Grid<S>&) const {
    shapes::require_half_size(body, half_size, std::numeric_limits<double>::infinity());
  }
  void permute(std::span<const std::uint32_t>) {}

  /// A corner of a domain: position, weight w_c and gradient g_c of its function.
  template <class Scalar>
  struct Corner {
    std::array<Scalar, 2> x;
    Scalar w;
    std::array<Scalar, 2> g;
  };
  /// Adds the nodes around four corners: weights sum w_c N_I(x_c), gradients sum g_c N_I(x_c). A node shared by corners
  /// stands once, unless the domain spans more than three cells.
  template <class S, class Out>
  static void corners(const Grid<S>& grid, const std::array<Corner<typename S::Scalar>, 4>& corner, Out& out) {
    using Scalar = typename S::Scalar;
    std::array<AxisStencil<Scalar, 2>, 4> a, b;
    for (int c = 0; c < 4; ++c) {
      a[c] = shapes::hat_axis(grid.coordinate(corner[c].x[0], 0), grid.cells(0));
      b[c] = shapes::hat_axis(grid.coordinate(corner[c].x[1], 1), grid.cells(1));
    }
    const std::pair<int, int> x = std::minmax({a[0].first, a[1].first, a[2].first, a[3].first});
    const std::pair<int, int> y = std::minmax({b[0].first, b[1].first, b[2].first, b[3].first});
    const int left = x.first, low = y.first;
    const int stride = grid.stride(1), width = x.second - left + 2, height = y.second - low + 2;
    if (width > 4 || height > 4) {
      for (int c = 0; c < 4; ++c)
        around(corner[c], a[c], b[c], [&](int i, int j, Scalar w, Scalar gx, Scalar gy) {
          out.add(i + j * stride, w, {gx, gy});
        });
      return;
    }
    std::array<std::array<Scalar, 3>, 16> patch{};
    for (int c = 0; c < 4; ++c)
      around(corner[c], a[c], b[c], [&](int i, int j, Scalar w, Scalar gx, Scalar gy) {
        auto& node = patch[std::size_t(4 * (j - low) + i - left)];
        node[0] += w, node[1] += gx, node[2] += gy;
      });
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) {
        const auto& node = patch[std::size_t(4 * j + i)];
        out.add(left + i + (low + j) * stride, node[0], {node[1], node[2]});
      }
  }

 private:
  /// Weights that a corner at `xi`, in cells, gives to the nodes below and above an anchor, and whether it is within a
  /// cell of it.
  template <class V>
  struct Hats {
    V w[2];
    bool near;
  };
  template <class V, class S>
  static V coordinate(const Grid<S>& grid, int d, const V& x) {
    return max(V(0), min((x - V(grid.origin()[d])) * V(grid.inverse_cell()), V(grid.cells(d))));
  }
  template <class V>
  [[gnu::always_inline]] static Hats<V> hats(const V& xi, const typename V::Integers& anchor) {
    const V t = xi - as_lanes<V>(anchor);
    return {{max(-t, V(0)), max(t, V(0))}, !any(abs(t) > V(1))};
  }
  template <class Scalar>
  using Axis = AxisStencil<Scalar, 2>;

  /// Adds the nodes around both ends of a segment, each once: weights 1/2 N_I, gradients -g N_I and g N_I.
  template <class S, class Out, class Scalar = typename S::Scalar>
  static void ends(const Grid<S>& grid, Scalar low, Scalar high, Scalar g, Out& out) {
    const auto a = shapes::hat_axis(grid.coordinate(low, 0), grid.cells(0));
    const auto b = shapes::hat_axis(grid.coordinate(high, 0), grid.cells(0));
    const int apart = b.first - a.first;
    const auto at = [](const Axis<Scalar>& hat, int i) { return i == 0 || i == 1 ? hat.w[i] : Scalar(0); };
    for (int i = 0; i < 2 + std::min(apart, 2); ++i) {
      const int node = i < 2 ? i : apart + i - std::min(apart, 2);  // those further in are not touched
      const Scalar l = at(a, node), h = at(b, node - apart);
      out.add(a.first + node, (l + h) / 2, {g * (h - l)});
    }
  }
  template <class Scalar, class F>
  static void around(const Corner<Scalar>& c, const Axis<Scalar>& a, const Axis<Scalar>& b, const F& f) {
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const Scalar N = a.w[i] * b.w[j];
        f(a.first + i, b.first + j, c.w * N, c.g[0] * N, c.g[1] * N);
      }
  }
};

static_assert(ShapeFunction<Cpdi>);

}  // namespace mpm
