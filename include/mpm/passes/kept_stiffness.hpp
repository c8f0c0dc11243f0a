// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/stable_step_lanes.hpp>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace mpm {

/// Weights along axes whose slopes do not jump, as those of the hat do at every node: how stiff the grid will be to a
/// particle on its way is then bounded by how stiff it is at both ends.
template <class Body>
concept Foreseeable = HasModes<Body> &&(Body::Shape::axis_nodes > 2);

namespace detail {

/// How far `count` particles from `first` on may move before how stiff the grid is to them is looked at again: a 25th
/// of the smallest, or of a cell.
template <class Body, class S>
typename S::Scalar reach_of(const Body& body, std::size_t first, std::size_t count, const Grid<S>& grid) {
  typename S::Scalar size = grid.cell();
  for (std::size_t p = first; p < first + count; ++p)
    size = std::min(size, body.template particle_size<typename S::Scalar>(p));
  return size / 25;
}
/// Whether one of them is so near a face of the grid that it matters: there a spline has the slope of a hat.
template <class Body, class S>
bool beside_a_face(const Body& body, std::size_t first, std::size_t count, const Grid<S>& grid,
                   typename S::Scalar reach) {
  if constexpr (continues_linearly<typename Body::Shape>)
    for (int d = 0; d < S::dimension; ++d)
      for (std::size_t p = first; p < first + count; ++p)
        if (std::min(body.x(d)[p] - grid.origin()[d], grid.upper(d) - body.x(d)[p]) < 4 * reach) return true;
  return false;
}
/// Moves them by `shift` along all axes, a radius by no more than half of it, and keeps their places.
template <class S, class Body, class Places>
void displace(Body& body, std::size_t first, std::size_t count, typename S::Scalar shift, Places& places) {
  for (int d = 0; d < S::dimension; ++d) {
    typename S::Scalar* const x = body.x(d) + first;
    std::copy_n(x, count, places[std::size_t(d)].begin());
    for (std::size_t k = 0; k < count; ++k) x[k] = S::hoop && d == 0 ? std::max(x[k] + shift, x[k] / 2) : x[k] + shift;
  }
}
template <class Body, class Places>
void put_back(Body& body, std::size_t first, std::size_t count, const Places& places) {
  for (int d = 0; d < Body::dimension; ++d) std::copy_n(places[std::size_t(d)].begin(), count, body.x(d) + first);
}

}  // namespace detail

/// The stiffness of the grid to the chunks of a body, kept while their particles move by less than their reach, a 25th
/// of their size or of a cell. It is the larger of those of the particles moved by +- reach along all axes, so that
/// nodes about to be touched count; CPDI's weights have no such kinks. Particles that come as far in a few steps are
/// looked at where they stand, in every step, and so are those of shapes that are not foreseeable.
template <class Body>
class KeptStiffness {
 public:
  using S = typename Body::SpaceType;
  using Scalar = typename S::Scalar;

  /// Whether that of chunk c is kept for this step.
  bool knows(std::size_t c) const { return left_[c] >= 0; }
  /// Whether chunk c is slow enough to keep what is found.
  bool worthwhile(std::size_t c) const { return slow_[c]; }

  void resize(std::size_t chunks) {
    left_.resize(chunks, -1), reach_.resize(chunks, 0), slow_.resize(chunks, 0), stiffness_.resize(chunks);
  }
  /// To be called after a step in which the particles of chunk c moved, or stretched, by `motion` at most along an
  /// axis.
  void note(const Body& body, std::size_t c, Scalar motion, const Grid<S>& grid) {
    if (reach_[c] == 0) look(body, c, grid);
    left_[c] -= motion;
    slow_[c] = smooth || 5 * motion < reach_[c];
  }
  void forget() { left_.clear(), reach_.clear(), slow_.clear(), stiffness_.clear(); }

  /// That of the chunk of `count` particles from `first` on.
  GridStiffness<Scalar> of(Body& body, std::size_t first, int count, const Grid<S>& grid) {
    const std::size_t c = first / chunk_size;
    if (knows(c)) return stiffness_[c];
    look(body, c, grid);
    if (!worthwhile(c)) return at(body, first, count, grid, 0);
    left_[c] = reach_[c];
    if constexpr (smooth) {
      stiffness_[c] = at(body, first, count, grid, 0);
    } else {
      stiffness_[c] = at(body, first, count, grid, reach_[c]);
      stiffness_[c].raise(at(body, first, count, grid, -reach_[c]));
    }
    return stiffness_[c];
  }

 private:
  static constexpr bool smooth = Body::Shape::domain_motion != DomainMotion::rigid && !HasModes<Body>;

  /// Finds how far the particles of chunk c may move; not at all where nothing is foreseeable.
  void look(const Body& body, std::size_t c, const Grid<S>& grid) {
    const std::size_t first = c * chunk_size, count = std::min<std::size_t>(chunk_size, body.size() - first);
    reach_[c] = detail::reach_of(body, first, count, grid);
    if (!smooth && (!Foreseeable<Body> || detail::beside_a_face(body, first, count, grid, reach_[c]))) {
      reach_[c] = -1;
      slow_[c] = 0;
    }
  }
  /// Of particles moved by `shift` along all axes; they are put back.
  static GridStiffness<Scalar> at(Body& body, std::size_t first, int count, const Grid<S>& grid, Scalar shift) {
    if (shift == 0) return detail::over_lanes(detail::chunk_stiffness(body, first, count, grid));
    std::array<std::array<Scalar, chunk_size>, S::dimension> places;
    detail::displace<S>(body, first, std::size_t(count), shift, places);
    const auto stiffness = detail::over_lanes(detail::chunk_stiffness(body, first, count, grid));
    detail::put_back(body, first, std::size_t(count), places);
    return stiffness;
  }

  // Of every chunk:
  std::vector<Scalar> left_;   ///< how far its particles may still move, m; negative where the stiffness is not known
  std::vector<Scalar> reach_;  ///< m, zero where it is not known
  std::vector<char> slow_;
  std::vector<GridStiffness<Scalar>> stiffness_;
};

}  // namespace mpm
