// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/kept_stiffness.hpp>
#include <utility>
#include <vector>

namespace mpm {

/// The masses of the nodes, shared among the particles of a body by how stiff each is to them. Irons' bound holds for
/// any shares that come to no more than the mass of a node; a particle's own, m_p w_Ip, serve its worst place, while
/// a neighbour often has mass to spare.
///
/// m_pI = m_I m_p s_pI / sum_q m_q s_qI with s = t_p (abs(w) + h sum_d abs(dw/dx_d)): first t = 1, then t_p is the
/// largest eigenvalue of the G_p that this makes, so that what needs more gets more (see GridStiffness).
template <class Body>
class SharedMass {
 public:
  using S = typename Body::SpaceType;
  using Scalar = typename S::Scalar;

  /// Shares the masses among the particles where they stand, at most a row of nodes from where they were ordered.
  void share(const Body& body, const ParticleOrder& order, const Grid<S>& grid) {
    const Scalar* m = body.mass();
    mass_.assign(grid.size(), 0), claims_.assign(grid.size(), 0), need_.assign(body.size(), 1);
    for_each_coloured<3>(order, [&](std::size_t p) {
      for (const auto& entry : make_stencil(body, p, grid)) {
        mass_[entry.node] += m[p] * entry.weight;
        claims_[entry.node] += m[p] * pull(entry, grid.cell());
      }
    });
    settle_claims();
    claims_.assign(grid.size(), 0);
    for_each_coloured<3>(order, [&](std::size_t p) {
      const auto stencil = make_stencil(body, p, grid);
      need_[p] = stiffness(body, p, grid, stencil).most;
      for (const auto& entry : stencil) claims_[entry.node] += m[p] * need_[p] * pull(entry, grid.cell());
    });
    settle_claims();
  }
  /// The stiffness of the grid to particle p with its shares.
  GridStiffness<Scalar> stiffness(const Body& body, std::size_t p, const Grid<S>& grid) const {
    return stiffness(body, p, grid, make_stencil(body, p, grid));
  }

 private:
  static Scalar pull(const auto& entry, Scalar cell) {
    Scalar slope = 0;
    for (Scalar g : entry.gradient) slope += std::abs(g);
    return std::abs(entry.weight) + cell * slope;
  }
  template <class Out>
  GridStiffness<Scalar> stiffness(const Body& body, std::size_t p, const Grid<S>& grid, const Out& stencil) const {
    const Scalar need = need_[p], cell = grid.cell();
    return grid_stiffness<S>(stencil, body.x(0)[p], cell, [&](const auto& entry) {
      const Scalar part = need * pull(entry, cell);
      return part == 0 ? std::numeric_limits<Scalar>::infinity() : claimed_[entry.node] / part;
    });
  }
  void settle_claims() {
    claimed_.resize(claims_.size());
    for (std::size_t n = 0; n < claims_.size(); ++n) claimed_[n] = claims_[n] / mass_[n];
  }

  std::vector<Scalar> mass_, claims_;  ///< of every node: m_I; sum m_p s_pI
  std::vector<Scalar> claimed_;        ///< the latter over the former
  std::vector<Scalar> need_;           ///< of every particle: t
};

/// A body whose particles keep their places may take a longer step: there is time to look at who shares their nodes
/// (see SharedMass), as what is found holds for some hundred steps. It is the larger of the stiffness to all particles
/// moved by +- their reach along all axes, as in KeptStiffness, but of the whole body at once.
template <class Body>
class CalmStiffness {
 public:
  using S = typename Body::SpaceType;
  using Scalar = typename S::Scalar;
  static constexpr int calm_steps = 512;  ///< so many steps take the particles no farther than `reach`

  /// Whether the stiffness of chunks is known.
  bool serves() const { return found_ && !steep_; }
  const GridStiffness<Scalar>& of_chunk(std::size_t c) const { return stiffness_[c]; }

  /// To be called after a step in which no particle moved by more than `motion` along an axis, m.
  void note(const Body& body, Scalar motion, const Grid<S>& grid) {
    if (reach_ == 0) reach_ = detail::reach_of(body, 0, body.size(), grid);
    steps_ = motion * calm_steps > reach_ ? 0 : std::min(steps_ + 1, calm_steps);
    moved_ += motion;
    if (moved_ > reach_) found_ = false;
  }
  /// The particles have another order, or their properties have changed.
  void forget() { steps_ = 0, found_ = false; }

  /// Finds the stiffness of the chunks, unless it is known, of a body all of which has been worked on, calmly, for
  /// `calm_steps`.
  void find_if_due(Body& body, const ParticleOrder& order, const Grid<S>& grid) {
    if (found_ || steps_ < calm_steps || order.chunks.size() != chunk_count(body)) return;
    const Scalar thought = std::exchange(reach_, detail::reach_of(body, 0, body.size(), grid));
    if (reach_ < Scalar(.9) * thought) {  // smaller particles have come since: are they calm?
      steps_ = 0;
    } else {
      find(body, order, grid);
    }
  }
  /// Finds the stiffness of the chunks for particles on their way.
  void find(Body& body, const ParticleOrder& order, const Grid<S>& grid) {
    reach_ = detail::reach_of(body, 0, body.size(), grid), moved_ = 0, found_ = true;
    steep_ = detail::beside_a_face(body, 0, body.size(), grid, reach_);
    if (steep_) return;
    find_at(body, order, grid, reach_, stiffness_);
    find_at(body, order, grid, -reach_, other_);
    for (std::size_t c = 0; c < stiffness_.size(); ++c) {
      auto &a = stiffness_[c], &b = other_[c];
      if (!(a.volume < 2 * b.volume && b.volume < 2 * a.volume)) steep_ = true;
      a.raise(b);
    }
  }

 private:
  /// Of the particles moved by `shift` along all axes; they are put back.
  void find_at(Body& body, const ParticleOrder& order, const Grid<S>& grid, Scalar shift,
               std::vector<GridStiffness<Scalar>>& stiffness) {
    for (auto& x : places_) x.resize(body.size());
    detail::displace<S>(body, 0, body.size(), shift, places_);
    shares_.share(body, order, grid);
    stiffness.assign(chunk_count(body), {});
    order.chunks.for_each([&](std::size_t first, int count) {
      for (std::size_t p = first; p < first + std::size_t(count); ++p)
        stiffness[first / chunk_size].raise(shares_.stiffness(body, p, grid));
    });
    detail::put_back(body, 0, body.size(), places_);
  }

  SharedMass<Body> shares_;
  std::array<std::vector<Scalar>, S::dimension> places_;
  std::vector<GridStiffness<Scalar>> stiffness_, other_;  ///< of every chunk
  Scalar reach_ = 0, moved_ = 0;                          ///< m; moved since it was found
  int steps_ = 0;                                         ///< calm ones on end
  bool found_ = false;
  bool steep_ = false;  ///< the way makes too much of a difference for that to be a bound
};

/// For bodies whose stable step is looked for in every step.
struct NeverCalm {
  static constexpr bool serves() { return false; }
  void note(const auto&, auto, const auto&) {}
  void forget() {}
};

}  // namespace mpm
