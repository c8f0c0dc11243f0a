// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/concepts/integrator.hpp>
#include <mpm/passes/advance_nodes.hpp>
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
    for_each_coloured(order, [&](std::size_t p) {
      const auto stencil = make_stencil(body, p, grid);
      const Vector<S> x = centre(stencil, grid), v = body.velocity(p);
      const auto C = affine_velocity(stencil, x, B, p, grid);
      const auto m = body.mass()[p];
      for (const auto& [I, w, grad] : stencil) {
        const Vector<S> r = grid.position(I) - x;
        grid.mass[I] += w * m;
        momentum[I] += w * m * (v + C * r);
      }
    });
  }
  /// B = sum w v_I (x_I - x_p)^T.
  template <class Body, class S, class ColumnsT>
  static void gather_columns(const Body& body, const ChunkList& chunks, const Grid<S>& grid, ColumnsT& B) {
    chunks.for_each_entry([&](std::size_t p) {
      const auto stencil = make_stencil(body, p, grid);
      const Vector<S> x = centre(stencil, grid);
      Matrix<S> sum = Matrix<S>::Zero();
      for (const auto& [I, w, grad] : stencil) sum += w * grid.velocity[I] * (grid.position(I) - x).transpose();
      for (int i = 0; i < S::dimension; ++i)
        for (int j = 0; j < S::dimension; ++j) B[i * S::dimension + j][p] = sum(i, j);
    });
  }

 private:
  template <class S>
  using Matrix = Eigen::Matrix<typename S::Scalar, S::dimension, S::dimension>;

  template <class Out, class S>
  static Vector<S> centre(const Out& stencil, const Grid<S>& grid) {
    Vector<S> x = Vector<S>::Zero();
    for (const auto& [I, w, grad] : stencil) x += w * grid.position(I);
    return x;
  }
  /// C = B D^-1 of particle p, 1/s, by elimination; columns of pivots that are next to nothing are zero.
  template <class Out, class ColumnsT, class S>
  static Matrix<S> affine_velocity(const Out& stencil, const Vector<S>& x, const ColumnsT& B, std::size_t p,
                                   const Grid<S>& grid) {
    using Scalar = typename S::Scalar;
    constexpr int n = S::dimension;
    Matrix<S> D = Matrix<S>::Zero(), C;
    Scalar farthest = 0;
    for (const auto& [I, w, grad] : stencil) {
      const Vector<S> r = grid.position(I) - x;
      D += w * r * r.transpose();
      farthest = std::max(farthest, r.squaredNorm());
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) C(i, j) = B[i * n + j][p];
    // D = L diag(pivot) L^T in the lower half of D, then C L^-T, the pivots, and L^-1 from the right.
    Vector<S> inverse;
    for (int k = 0; k < n; ++k) {
      inverse[k] = D(k, k) > farthest / 256 ? 1 / D(k, k) : 0;
      for (int i = k + 1; i < n; ++i)
        for (int j = k + 1; j <= i; ++j) D(i, j) -= D(i, k) * D(j, k) * inverse[k];
      for (int i = k + 1; i < n; ++i) D(i, k) *= inverse[k];
    }
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < k; ++j) C.col(k) -= C.col(j) * D(k, j);
    for (int k = n - 1; k >= 0; --k) {
      C.col(k) *= inverse[k];
      for (int j = k + 1; j < n; ++j) C.col(k) -= C.col(j) * D(j, k);
    }
    return C;
  }
};

static_assert(Integrator<Apic>);

}  // namespace mpm
