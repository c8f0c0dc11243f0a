// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body_force.hpp>
#include <mpm/concepts/integrator.hpp>
#include <mpm/corner_nodes.hpp>
#include <mpm/passes/corner_lanes.hpp>
#include <mpm/passes/shared_mass.hpp>

namespace mpm {

namespace detail {
/// In place of an integrator for passes that leave the particles' velocities: they are the same for all.
struct LeftAlone {
  explicit LeftAlone(const auto&) {}
};
}  // namespace detail

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
  /// Fast passes for shapes in modes, and for corners; the plain ones for all others. The weights of all passes must be
  /// the same to the last bit where a particle only just touches a node.
  static constexpr bool in_modes = InModes<Body> && !by_corners;
  /// Weights along axes tell a scatter at once how stiff the grid is to the particles.
  static constexpr bool sees_stiffness = in_modes && HasModes<Body> && IntegratorT::step_interval == 1;
  static constexpr bool may_be_calm = Foreseeable<Body> && IntegratorT::step_interval == 1;
  static constexpr bool corners_in_lanes = std::is_same_v<Shape, CpdiQuad>;

  static constexpr bool domains_change = Shape::domain_motion != DomainMotion::rigid;
  /// Domains are looked at again only when they may have drifted out of their places; not so where F changes between
  /// two passes of one step (USF).
  static constexpr bool may_settle =
      by_corners || (domains_change && IntegratorT::stress_update != StressUpdate::first);

  /// Orders the particles and marks the blocks in use. Domains keep their places while none has moved or stretched by
  /// as much as their strips leave room for.
  void locate(Body& body, Grid<S>& grid) {
    columns_.resize(body.size());
    inverse_square_step_ = unknown_;
    const bool settled =
        may_settle && limits_.size() == chunk_count(body) && strayed_ < Scalar(detail::slack<Shape>) * grid.cell();
    if (!settled) strayed_ = 0;
    const bool grown = order_.key.size() != body.size();
    const Relocated changed = mpm::locate(body, grid, order_, settled);
    StepLimits<Scalar> limits_of_all;  // not known
    if (changed == Relocated::order) {
      columns_.permute({order_.permutation.data(), body.size()}, scratch_);
      if (!grown) limits_of_all = over_chunks(limits_);
      forget();
    }
    limits_.resize(chunk_count(body), limits_of_all);
    kept_.resize(chunk_count(body));
    if constexpr (by_corners) {
      if (changed != Relocated::nothing) corners_.choose(body.shape, order_.chunks);
      corners_.locate(body.shape.corner, grid);
    }
  }
  /// The chunks of particles that are worked on; all of them, if there are not as many particles as when they were
  /// last located.
  const ChunkList& chunks_of(std::size_t particles) {
    if (order_.chunks.entries() != particles) order_.chunks.take_all(particles);
    return order_.chunks;
  }
  /// Calls f(node) for the nodes of the particles that rest, of those with a block in use beside theirs.
  template <class F>
  void for_each_resting_node(const Body& body, const Grid<S>& grid, const F& f) const {
    std::size_t listed = 0;
    for (std::size_t first = 0; first < body.size(); first += chunk_size) {
      if (listed < order_.chunks.size() && order_.chunks.first(listed) == first) {
        ++listed;
        continue;
      }
      for (std::size_t p = first; p < std::min(first + chunk_size, body.size()); ++p) {
        bool beside = false;
        grid.for_each_block_around(int(order_.key[p] / Grid<S>::nodes_per_block), 1,
                                   [&](int block) { beside = beside || grid.active(block); });
        if (!beside) continue;
        for (const auto& entry : make_stencil(body, p, grid)) f(entry.node);
      }
    }
  }
  const auto& nodes(const Grid<S>& grid) const {
    if constexpr (by_corners) {
      return corners_;
    } else {
      return grid;
    }
  }

  /// Gives mass, momentum or forces of the particles to the grid, and the pressure on the surface that corners may
  /// have: m_I += w m, momentum_I += w m v, f_I += -V sigma grad w + w m b. A pass that `measures` may find the stable
  /// step on its way.
  template <What what, bool measures = false, BodyForce<Body> Force>
  std::size_t scatter(const Body& body, Grid<S>& grid, std::vector<Vector<S>>& momentum, const Force& body_force,
                      double time) {
    if constexpr (column_count > 0 && gives_momentum<what>) {
      IntegratorT::scatter_momentum(body, order_, columns_, grid, momentum);
      if constexpr (gives_forces<what>) {
        return scatter<What::forces, measures>(body, grid, momentum, body_force, time);
      } else {
        return body.size();
      }
    } else if constexpr (by_corners) {
      return scatter_by_corners<what>(body, grid, momentum, body_force, time);
    } else {
      constexpr bool finds_step = measures && sees_stiffness;
      return scatter_to<what, finds_step>(body, grid, momentum, body_force, time);
    }
  }
  /// The way back: velocities from the nodes as the integrator blends them (`Blend`), strain and stress, and positions
  /// (`Move`). Corners, and velocities of nodes that are not asked for, stay. Returns the first particle whose volume
  /// or stress is no longer a finite positive number, or body.size().
  template <bool Blend, Strained strained, bool Move>
  std::size_t update(Body& body, const Grid<S>& grid, const IntegratorT& integrator, Scalar time, Scalar dt) {
    inverse_square_step_ = unknown_;
    constexpr bool second = Blend || strained == Strained::by_second;
    if constexpr (column_count > 0 && Blend) IntegratorT::gather_columns(body, order_.chunks, grid, columns_);
    const auto& own = nodes(grid);
    if constexpr (corners_in_lanes) {
      lanes::gather_corners(corners_, grid.velocity,
                            !second ? grid.velocity
                            : Blend ? grid.increment
                                    : grid.strain_velocity);
    } else if constexpr (by_corners) {
      corners_.gather(grid.velocity, corners_.velocity);
      if constexpr (Blend) corners_.gather(grid.increment, corners_.increment);
      if constexpr (strained == Strained::by_second) corners_.gather(grid.strain_velocity, corners_.strain_velocity);
    }
    const auto& other = !second ? own.velocity : Blend ? own.increment : own.strain_velocity;
    const std::conditional_t<Blend, const IntegratorT&, detail::LeftAlone> blend(integrator);
    std::size_t bad = body.size();
    if constexpr (corners_in_lanes) {
      bad = lanes::update<Blend, strained>(body, order_.chunks, corners_, grid.cell(), blend, time, dt, partial_,
                                           limits_);
    } else if constexpr (in_modes) {
      bad = lanes::update<Blend, strained, Move>(body, order_.chunks, grid, own.velocity, other, blend, time, dt,
                                                 partial_, limits_);
    } else {
      if constexpr (Blend) gather_velocity(body, order_.chunks, own, integrator);
      if constexpr (strained != Strained::none) {
        const auto& velocity = strained == Strained::by_first ? own.velocity : own.strain_velocity;
        if constexpr (mean_dilatation<Shape>) dilatation_.find(body, order_.chunks, own, grid, velocity);
        constexpr bool rides = Move && !by_corners;
        bad = update_stress<rides>(body, order_.chunks, own, velocity, dilatation_, grid.cell(), time, dt, partial_,
                                   limits_);
      } else if constexpr (Move && !by_corners) {
        order_.chunks.for_each([&](std::size_t first, int count) {
          StepLimits<Scalar>& limit = limits_[first / chunk_size];
          limit.speed = 0;
          for (std::size_t p = first; p < first + std::size_t(count); ++p)
            ride<S>(body, p, make_stencil(body, p, own), own, dt, limit);
        });
      }
    }
    if constexpr (Move && by_corners && !corners_in_lanes) {
      Scalar fastest = 0;
      for (const Vector<S>& v : strained == Strained::by_second ? corners_.strain_velocity : corners_.velocity)
        fastest = std::max(fastest, v.cwiseAbs().maxCoeff());
      for (auto& limit : limits_) limit.speed = fastest;
    }
    if constexpr (Move) note_motion(body, grid, dt);
    return bad;
  }
  /// Corners ride the nodes, with the field that strained the particles. Returns the first particle whose domain has
  /// inverted, or body.size().
  template <Strained strained>
  std::size_t convect(Body& body, Scalar dt) {
    if constexpr (by_corners) {
      static_assert(
          requires { body.shape.convect(body, corners_.velocity, dt, corners_.chunks(), order_.chunks); },
          "mpm::ShapeFunction: domain_motion is `corners`, so the shape must have the member convect(body, velocity, "
          "dt, corners, particles), which moves its domains");
      if constexpr (corners_in_lanes) {
        lanes::move_corners<strained>(body.shape, corners_, dt);
        return lanes::follow_corners(body, order_.chunks);
      } else {
        return body.shape.convect(body, strained == Strained::by_second ? corners_.strain_velocity : corners_.velocity,
                                  dt, corners_.chunks(), order_.chunks);
      }
    } else {
      return body.size();
    }
  }
  /// out_I += sum_p w_Ip m_p sum_J w_Jp in_J, of fields of the grid. Takes the corners' velocity and increment for its
  /// own use.
  void scatter_interpolated(const Body& body, const Grid<S>& grid, const std::vector<Vector<S>>& in,
                            std::vector<Vector<S>>& out) {
    if constexpr (corners_in_lanes) {
      corners_.gather(in, corners_.velocity);
      lanes::scatter_interpolated(body, order_, corners_);
      lanes::scatter_corners<false, true, false>(corners_, grid.mass, out, out);
    } else if constexpr (by_corners) {
      corners_.gather(in, corners_.velocity);
      corners_.for_each([&](std::size_t c) { corners_.increment[c].setZero(); });
      mpm::scatter_interpolated(body, order_, corners_, corners_.velocity, corners_.increment);
      corners_.scatter([&](std::size_t c, int I, Scalar w) { out[I] += w * corners_.increment[c]; });
    } else if constexpr (in_modes) {
      lanes::scatter_interpolated(body, order_, grid, in, out);
    } else {
      mpm::scatter_interpolated(body, order_, grid, in, out);
    }
  }
  /// Sum of abs(V sigma grad w) a node.
  void scatter_force_scale(const Body& body, const Grid<S>& grid, std::vector<Scalar>& scale) const {
    mpm::scatter_force_scale(body, order_, grid, scale);
  }

  /// The largest stable step of the body: with shared masses while all of it is calm, otherwise from what is kept of
  /// its chunks or the scatter has just seen; others are looked at.
  Scalar stable_step(Body& body, const Grid<S>& grid) {
    if (IntegratorT::step_interval > 1) return mpm::stable_step(body, order_.chunks, grid);
    if constexpr (may_be_calm) {
      calm_.find_if_due(body, order_, grid);
      if (calm_.serves())
        return mpm::stable_step(
            body, order_.chunks, grid, limits_, [](std::size_t) { return true; },
            [&](std::size_t first, int) { return calm_.of_chunk(first / chunk_size); });
    }
    const bool all_seen = inverse_square_step_ < unknown_;
    const Scalar seen = std::max(all_seen ? inverse_square_step_ : 0, std::numeric_limits<Scalar>::min());
    if (all_seen && !Foreseeable<Body>) return 1 / std::sqrt(seen);
    const Scalar others = mpm::stable_step(
        body, order_.chunks, grid, limits_,
        [&](std::size_t c) { return !all_seen || kept_.knows(c) || kept_.worthwhile(c); },
        [&](std::size_t first, int count) { return kept_.of(body, first, count, grid); });
    return std::min(others, 1 / std::sqrt(seen));
  }

  /// Forgets what the last step knew of the particles.
  void forget() {
    limits_.clear();
    kept_.forget();
    calm_.forget();
  }

  const Columns<Scalar, column_count>& columns() const { return columns_; }

 private:
  static constexpr Scalar unknown_ = std::numeric_limits<Scalar>::infinity();
  /// How far particles, or domains that stretch, may have moved in this step.
  void note_motion(const Body& body, const Grid<S>& grid, Scalar dt) {
    if constexpr (!domains_change && !Foreseeable<Body>) return;
    Scalar farthest = 0;
    for (std::size_t c = 0; c < limits_.size(); ++c) {
      Scalar motion = dt * limits_[c].speed;
      if constexpr (domains_change) motion += dt * grid.cell() * std::sqrt(limits_[c].rate);
      kept_.note(body, c, motion, grid);
      farthest = std::max(farthest, motion);
    }
    strayed_ += farthest;
    calm_.note(body, farthest, grid);
  }
  template <What what, bool measures, class Nodes, class Force>
  std::size_t scatter_to(const Body& body, Nodes& own, std::vector<Vector<S>>& momentum, const Force& body_force,
                         double time) {
    const auto plainly = [&](std::size_t begin, std::size_t end) {
      std::size_t bad = body.size();
      for (std::size_t p = begin; p < end; ++p)
        bad = std::min(bad, scatter_plainly<what>(body, p, own, momentum, body_force, time));
      return bad;
    };
    std::size_t bad;
    if constexpr (in_modes) {
      Scalar inverse_square = 0;
      const auto looks_at = [&](std::size_t c) { return !calm_.serves() && !kept_.knows(c); };
      bad = lanes::scatter<what, measures>(body, order_, own, momentum, body_force, time, limits_, looks_at,
                                           inverse_square);
      if (measures && order_.tail_begin() == body.size()) inverse_square_step_ = inverse_square;
    } else {
      bad = for_each_strip(order_, plainly);
    }
    return std::min(bad, plainly(order_.tail_begin(), body.size()));
  }
  template <What what, class Force>
  std::size_t scatter_by_corners(const Body& body, Grid<S>& grid, std::vector<Vector<S>>& momentum,
                                 const Force& body_force, double time) {
    const bool loaded = gives_forces<what> && body.shape.pressure != 0;
    if constexpr (corners_in_lanes) {
      corners_.for_each([&](std::size_t c) { corners_.mass[c] = 0, corners_.pair[c] = {}; });
      const std::size_t bad = lanes::scatter<what>(body, order_, corners_, body_force, time);
      if (loaded)
        body.shape.load_surface([&](std::size_t c, const std::array<double, 2>& f) {
          for (std::size_t d = 0; d < 2; ++d) corners_.pair[c].value[2 + d] += Scalar(f[d]);
        });
      lanes::scatter_corners<gives_mass<what>, gives_momentum<what>, gives_forces<what>>(corners_, grid.mass, momentum,
                                                                                         grid.increment);
      return bad;
    } else {
      corners_.for_each([&](std::size_t c) {
        corners_.mass[c] = 0, corners_.velocity[c].setZero(), corners_.increment[c].setZero();
      });
      const std::size_t bad = scatter_to<what, false>(body, corners_, corners_.velocity, body_force, time);
      if (loaded)
        body.shape.load_surface([&](std::size_t c, const std::array<double, 2>& f) {
          corners_.increment[c] += Vector<S>(Scalar(f[0]), Scalar(f[1]));
        });
      corners_.scatter([&](std::size_t c, int I, Scalar w) {
        if constexpr (gives_mass<what>) grid.mass[I] += w * corners_.mass[c];
        if constexpr (gives_momentum<what>) momentum[I] += w * corners_.velocity[c];
        if constexpr (gives_forces<what>) grid.increment[I] += w * corners_.increment[c];
      });
      return bad;
    }
  }

  ParticleOrder order_;
  Columns<Scalar, column_count> columns_;
  std::vector<Scalar> scratch_;
  std::conditional_t<by_corners, CornerNodes<S>, NodalFields<S>> corners_;
  std::conditional_t<mean_dilatation<Shape>, CellDilatation<S>, OwnDilatation> dilatation_;
  std::vector<StrainWork> partial_;
  std::vector<StepLimits<Scalar>> limits_;  ///< of every chunk
  KeptStiffness<Body> kept_;
  Scalar inverse_square_step_ = unknown_;  ///< 1/dt^2 of the stable step, where a scatter has found it
  std::conditional_t<may_be_calm, CalmStiffness<Body>, NeverCalm> calm_;
  Scalar strayed_ = 0;  ///< largest motion since the places were found, m
};

}  // namespace mpm
