// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/integrator.hpp>
#include <mpm/passes/advance_nodes.hpp>
#include <mpm/passes/affine_lanes.hpp>
#include <mpm/passes/gather.hpp>
#include <algorithm>
#include <cmath>

namespace mpm {

/// APIC, the affine particle-in-cell method (Jiang, Schroeder, Selle, Teran & Stomakhin 2015): particles take the
/// velocity of the nodes, v_p = S v+, and remember how it varies around them, B = sum w v_I+ (x_I - x_p)^T, so that a
/// node gets the momentum w m (v_p + C (x_I - x_p)), C = B D^-1, D = sum w (x_I - x_p)(x_I - x_p)^T. The stress is
/// updated last. For x_p stands the centre of the weights, sum w x_I: it lies elsewhere only where a face of the grid
/// cuts a box of uGIMP, and round x_p a particle would gain energy there.
///
/// Filters what the grid cannot see, and conserves angular momentum, sum m (x_p x v_p + B : epsilon). D is taken from
/// the stencil itself, so that every shape works: it is h^2/4 for the quadratic spline, h^2/3 for the cubic one, and
/// between h^2/4 and h^2/8 for GIMP with two particles an edge. Quadrilaterals (CPDI2) talk to the nodes of the grid
/// here, as B of their corners alone would lose angular momentum like PIC; they conserve it up to the drift of their
/// centroids.
///
/// The linear shape has D = 0 along each axis whose grid line a particle stands on. There, and wherever a pivot of D is
/// below 1/256 of the largest (x_I - x_p)^2, the particle is PIC along that axis for one step, and its share of the
/// angular momentum is lost.
struct Apic {
  static constexpr StressUpdate stress_update = StressUpdate::last;
  static constexpr bool keeps_node_velocity = false;
  static constexpr int step_interval = 1;
  template <class S>
  static constexpr int particle_columns = S::dimension* S::dimension;  ///< B, m2/s, row by row

  template <class S>
  void advance(Grid<S>& grid, typename S::Scalar dt) const {
    advance_nodes(grid, dt);
  }
  template <class Scalar>
  Scalar particle_velocity(Scalar, Scalar v, Scalar) const {
    return v;
  }
  /// Share of the stable step. A mode of which the way to the particles and back keeps the share p, 0 to 1, is stable
  /// while dt^2 w^2 < 2 (1 + p).
  double step_factor() const { return std::sqrt(0.5); }

  /// m_I += w m and momentum_I += w m (v_p + C (x_I - x_p)).
  template <class Body, class ColumnsT, class S>
  static void scatter_momentum(const Body& body, const ParticleOrder& order, const ColumnsT& B, Grid<S>& grid,
                               std::vector<Vector<S>>& momentum) {
    const auto plainly = [&](std::size_t p) { add_momentum(body, p, B, grid, momentum); };
    if constexpr (InModes<Body>) {
      lanes::scatter_affine(
          body, order, B, grid, momentum, [](auto&&... arguments) { affine_velocity(arguments...); }, plainly);
    } else {
      for_each_coloured(order, plainly);
    }
  }
  /// Of one particle: the plain form.
  template <class Body, class ColumnsT, class S>
  static void add_momentum(const Body& body, std::size_t p, const ColumnsT& B, Grid<S>& grid,
                           std::vector<Vector<S>>& momentum) {
    using Scalar = typename S::Scalar;
    constexpr int n = S::dimension;
    const auto stencil = make_stencil(body, p, grid);
    const Vector<S> x = centre(stencil, grid), v = body.velocity(p);
    Scalar own[n][n], D[n][n] = {}, C[n][n], farthest = 0;
    for (const auto& [I, w, grad] : stencil) {
      const Vector<S> r = grid.position(I) - x;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) D[i][j] += w * r[i] * r[j];
      farthest = std::max(farthest, r.squaredNorm());
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) own[i][j] = B[i * n + j][p];
    affine_velocity(own, D, farthest, C);
    const Scalar m = body.mass()[p];
    for (const auto& [I, w, grad] : stencil) {
      const Vector<S> r = grid.position(I) - x;
      grid.mass[I] += w * m;
      for (int i = 0; i < n; ++i) {
        Scalar velocity = v[i];
        for (int j = 0; j < n; ++j) velocity += C[i][j] * r[j];
        momentum[I][i] += w * m * velocity;
      }
    }
  }
  /// B = sum w v_I (x_I - x_p)^T.
  template <class Body, class S, class ColumnsT>
  static void gather_columns(const Body& body, const ChunkList& chunks, const Grid<S>& grid, ColumnsT& B) {
    const auto plainly = [&](std::size_t p) { find_columns(body, p, grid, B); };
    if constexpr (InModes<Body>) {
      lanes::gather_affine(body, chunks, grid, B, plainly);
    } else {
      chunks.for_each_entry(plainly);
    }
  }
  /// Of one particle: the plain form.
  template <class Body, class S, class ColumnsT>
  static void find_columns(const Body& body, std::size_t p, const Grid<S>& grid, ColumnsT& B) {
    const auto stencil = make_stencil(body, p, grid);
    const Vector<S> x = centre(stencil, grid);
    for (int i = 0; i < S::dimension; ++i)
      for (int j = 0; j < S::dimension; ++j) {
        typename S::Scalar sum = 0;
        for (const auto& [I, w, grad] : stencil) sum += w * grid.velocity[I][i] * (grid.position(I) - x)[j];
        B[i * S::dimension + j][p] = sum;
      }
  }

 private:
  template <class Out, class S>
  static Vector<S> centre(const Out& stencil, const Grid<S>& grid) {
    Vector<S> x = Vector<S>::Zero();
    for (const auto& [I, w, grad] : stencil) x += w * grid.position(I);
    return x;
  }
  /// C = B D^-1, 1/s, by elimination; columns of pivots that are next to nothing are zero. Of D the lower half is read,
  /// and lost.
  template <class V, int n>
  static void affine_velocity(const V (&B)[n][n], V (&D)[n][n], const V& farthest, V (&C)[n][n]) {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) C[i][j] = B[i][j];
    // D = L diag(pivot) L^T in the lower half of D, then C L^-T, the pivots, and L^-1 from the right.
    V inverse[n];
    for (int k = 0; k < n; ++k) {
      inverse[k] = select(D[k][k] > farthest * V(1.0 / 256), V(1) / D[k][k], V(0));
      for (int i = k + 1; i < n; ++i)
        for (int j = k + 1; j <= i; ++j) D[i][j] -= D[i][k] * D[j][k] * inverse[k];
      for (int i = k + 1; i < n; ++i) D[i][k] *= inverse[k];
    }
    for (int row = 0; row < n; ++row) {
      V* c = C[row];
      for (int k = 0; k < n; ++k)
        for (int j = 0; j < k; ++j) c[k] -= c[j] * D[k][j];
      for (int k = n - 1; k >= 0; --k) {
        c[k] *= inverse[k];
        for (int j = k + 1; j < n; ++j) c[k] -= c[j] * D[j][k];
      }
    }
  }
};

static_assert(Integrator<Apic>);

}  // namespace mpm
