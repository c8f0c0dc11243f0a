// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body.hpp>
#include <mpm/error.hpp>
#include <cmath>
#include <limits>

namespace mpm {
namespace detail {

/// Adds a particle for one lattice cell, whose centre is `x`.
template <class Body>
class LatticeFiller {
 public:
  using S = typename Body::SpaceType;
  using Scalar = typename Body::Scalar;
  using Index = std::array<int, S::dimension>;

  LatticeFiller(Body& body, const Vector<S>& lower, Scalar spacing, const Index& cells)
      : body_(body), lower_(lower), spacing_(spacing), cells_(cells) {
    if constexpr (requires { body.shape.half_size; }) {
      for (int d = 0; d < S::dimension; ++d) {
        double& half = body.shape.half_size[d];
        if (half != 0 && std::abs(half - spacing / 2) > 1e-6 * half)
          throw Error("fill: the particles of body " + body.name + " have another size; make a second body");
        half = double(spacing) / 2;
      }
    }
    if constexpr (has_corners) corner_.assign(std::size_t(cells[0] + 1) * std::size_t(cells[1] + 1), none);
  }
  void add(const Index& cell, const Vector<S>& x, const Vector<S>& velocity) {
    const Scalar box = std::pow(spacing_, Scalar(S::dimension));
    if constexpr (has_corners)
      body_.shape.quad.push_back({corner(cell, 0, 0), corner(cell, 1, 0), corner(cell, 1, 1), corner(cell, 0, 1)});
    body_.add(x, S::hoop ? box * x[0] : box, velocity);
  }

 private:
  static constexpr bool has_corners = Body::Shape::domain_motion == DomainMotion::corners;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t corner(const Index& cell, int i, int j) {
    std::uint32_t& c = corner_[std::size_t(cell[1] + j) * std::size_t(cells_[0] + 1) + std::size_t(cell[0] + i)];
    if (c == none) {
      c = std::uint32_t(body_.shape.corner.size());
      body_.shape.corner.push_back(
          {double(lower_[0]) + double(spacing_) * (cell[0] + i), double(lower_[1]) + double(spacing_) * (cell[1] + j)});
    }
    return c;
  }

  Body& body_;
  Vector<S> lower_;
  Scalar spacing_;
  Index cells_;
  std::vector<std::uint32_t> corner_;  // of the body's shape, by lattice point
};

}  // namespace detail

/// Fills the part of the box from `lower` to `upper` where `inside(x)` holds with particles, all moving with
/// `velocity`: one at the centre of each cell, of edge `spacing` (m), of a lattice that starts at `lower`.
///
/// Their domains tile what is filled: shapes with a half size get half the spacing, and quadrilaterals share their
/// corners. Throws Error on a spacing that is not positive, and if the body's particles have another size.
template <class Body, class Inside>
void fill(Body& body, const Vector<typename Body::SpaceType>& lower, const Vector<typename Body::SpaceType>& upper,
          typename Body::Scalar spacing, const Inside& inside,
          const Vector<typename Body::SpaceType>& velocity = Vector<typename Body::SpaceType>::Zero()) {
  using S = typename Body::SpaceType;
  if (!(spacing > 0)) throw Error("fill: the spacing of body " + body.name + " must be positive");
  std::array<int, S::dimension> cells, cell{};
  std::int64_t count = 1;
  for (int d = 0; d < S::dimension; ++d) count *= cells[d] = int(std::lround((upper[d] - lower[d]) / spacing));
  detail::LatticeFiller<Body> filler(body, lower, spacing, cells);
  for (std::int64_t k = 0; k < count; ++k) {
    Vector<S> x;
    std::int64_t rest = k;
    for (int d = 0; d < S::dimension; rest /= cells[d++]) {
      cell[d] = int(rest % cells[d]);
      x[d] = lower[d] + spacing * (typename S::Scalar(cell[d]) + typename S::Scalar(0.5));
    }
    if (inside(x)) filler.add(cell, x, velocity);
  }
}

/// Fills the whole box.
template <class Body>
void fill(Body& body, const Vector<typename Body::SpaceType>& lower, const Vector<typename Body::SpaceType>& upper,
          typename Body::Scalar spacing) {
  fill(body, lower, upper, spacing, [](const auto&) { return true; });
}

}  // namespace mpm
