// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body_force.hpp>
#include <mpm/concepts/integrator.hpp>
#include <mpm/corner_nodes.hpp>
#include <mpm/passes/gather.hpp>
#include <mpm/passes/locate.hpp>
#include <mpm/passes/scatter.hpp>

namespace mpm {

/// The passes between one body and the grid: straight, or by way of the body's own corners where its domains have them.
/// `nodes(grid)` is what the particles talk to. Holds the particle columns of an integrator that has its own.
template <class Body, class IntegratorT>
class Transfer {
 public:
  using S = typename Body::SpaceType;
  using Scalar = typename S::Scalar;
  using Shape = typename Body::Shape;
  static_assert(
      requires { Shape::template max_nodes<S>; },
      "mpm::ShapeFunction: `max_nodes<Space>` is missing, the size of the largest stencil");
  static_assert(
      requires(const Body b, const Grid<S> grid, Stencil<Scalar, S::dimension, 1> out) {
        b.shape.stencil(b, std::size_t{}, grid, out);
      },
      "mpm::ShapeFunction: `stencil(body, p, grid, out)` is missing, which adds the nodes of a particle with w_Ip and "
      "grad w_Ip");
  static_assert(
      requires(const Body b, const Grid<S> grid) { b.shape.reach(b, std::size_t{}, grid); },
      "mpm::ShapeFunction: `reach(body, p, grid)` is missing, by which particles are ordered for the threads");
  static constexpr bool by_corners = Shape::domain_motion == DomainMotion::corners;
  static constexpr int column_count = particle_columns<IntegratorT, S>;

  void locate(Body& body, Grid<S>& grid) {
    columns_.resize(body.size());
    if (mpm::locate(body, grid, order_)) columns_.permute({order_.permutation.data(), body.size()}, scratch_);
    if constexpr (by_corners) corners_.locate(body.shape.corner, grid);
  }
  const auto& nodes(const Grid<S>& grid) const {
    if constexpr (by_corners) {
      return corners_;
    } else {
      return grid;
    }
  }

  /// m_I += w m and momentum_I += w m v, into the field of the grid that is named.
  void scatter_momentum(const Body& body, Grid<S>& grid, std::vector<Vector<S>>& momentum) {
    if constexpr (column_count > 0) {
      IntegratorT::scatter_momentum(body, order_, columns_, grid, momentum);
    } else if constexpr (by_corners) {
      corners_.for_each([&](std::size_t c) { corners_.mass[c] = 0, corners_.velocity[c].setZero(); });
      mpm::scatter_momentum(body, order_, corners_, corners_.velocity);
      corners_.scatter([&](std::size_t c, int I, Scalar w) {
        grid.mass[I] += w * corners_.mass[c];
        momentum[I] += w * corners_.velocity[c];
      });
    } else {
      mpm::scatter_momentum(body, order_, grid, momentum);
    }
  }
  /// The integrator's own columns, from the advanced nodes.
  void gather_columns(const Body& body, const Grid<S>& grid) {
    if constexpr (column_count > 0) IntegratorT::gather_columns(body, grid, columns_);
  }
  /// m_I += w m.
  void scatter_mass(const Body& body, Grid<S>& grid) {
    if constexpr (by_corners) {
      mpm::scatter_mass(body, order_, corners_);
      corners_.scatter([&](std::size_t c, int I, Scalar w) { grid.mass[I] += w * corners_.mass[c]; });
    } else {
      mpm::scatter_mass(body, order_, grid);
    }
  }
  /// out_I += sum_p w_Ip m_p sum_J w_Jp in_J, of fields of the grid. Takes the corners' velocity and increment for its
  /// own use: fetch them after.
  void scatter_interpolated(const Body& body, const Grid<S>& grid, const std::vector<Vector<S>>& in,
                            std::vector<Vector<S>>& out) {
    if constexpr (by_corners) {
      corners_.gather(in, corners_.velocity);
      corners_.for_each([&](std::size_t c) { corners_.increment[c].setZero(); });
      mpm::scatter_interpolated(body, order_, corners_, corners_.velocity, corners_.increment);
      corners_.scatter([&](std::size_t c, int I, Scalar w) { out[I] += w * corners_.increment[c]; });
    } else {
      mpm::scatter_interpolated(body, order_, grid, in, out);
    }
  }
  /// f_I += -V sigma grad w + w m b, and the pressure on the surface that corners may have.
  template <BodyForce<Body> Force>
  void scatter_force(const Body& body, Grid<S>& grid, const Force& body_force, double time) {
    if constexpr (by_corners) {
      mpm::scatter_force(body, order_, corners_, body_force, time);
      if (body.shape.pressure != 0) body.shape.load_surface(corners_.increment);
      corners_.scatter([&](std::size_t c, int I, Scalar w) { grid.increment[I] += w * corners_.increment[c]; });
    } else {
      mpm::scatter_force(body, order_, grid, body_force, time);
    }
  }
  /// Sum of abs(V sigma grad w) a node.
  void scatter_force_scale(const Body& body, const Grid<S>& grid, std::vector<Scalar>& scale) const {
    mpm::scatter_force_scale(body, order_, grid, scale);
  }

  /// Brings fields of the grid to what the particles talk to.
  void fetch_velocity(const Grid<S>& grid) {
    if constexpr (by_corners) corners_.gather(grid.velocity, corners_.velocity);
  }
  void fetch_increment(const Grid<S>& grid) {
    if constexpr (by_corners) corners_.gather(grid.increment, corners_.increment);
  }
  void fetch_strain_velocity(const Grid<S>& grid) {
    if constexpr (by_corners) corners_.gather(grid.strain_velocity, corners_.strain_velocity);
  }

  const Columns<Scalar, column_count>& columns() const { return columns_; }

 private:
  ParticleOrder order_;
  Columns<Scalar, column_count> columns_;
  std::vector<Scalar> scratch_;
  std::conditional_t<by_corners, CornerNodes<S>, NodalFields<S>> corners_;
};

}  // namespace mpm
