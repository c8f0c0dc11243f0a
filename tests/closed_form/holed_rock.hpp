// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/analysis/kirsch.hpp>
#include <mpm/analysis/ring_fit.hpp>
#include <mpm/geometry/holed_block.hpp>
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
#include <mpm/relax.hpp>
#include <array>
#include <vector>

// What the tests of the blast hole's rock share: the paper's hole, rock with it, and the particles' stresses.
namespace holed_rock {

using Plane = mpm::PlaneStrain<>;
using mpm::geometry::Model;
constexpr double a = 0.021;  ///< hole's radius, m

/// The block of `side` radii half side with two particles an edge of a cell of `a / cells` m.
inline mpm::geometry::HoledBlock block(double side, double cells, Model model = Model::quarter) {
  return {.radius = a, .half_side = side * a, .particle_size = a / (2 * cells), .model = model};
}

/// The grid that ends on the block's faces.
inline mpm::Grid<Plane> grid(double side, double cells, Model model = Model::quarter) {
  const int half = int(std::lround(side * cells));
  if (model == Model::quarter) return {{0, 0}, a / cells, {half, half}};
  return {{-side * a, -side * a}, a / cells, {2 * half, 2 * half}};
}

/// Copies of the particles' stresses, as the read-outs take them.
class Samples {
 public:
  template <class Body>
  explicit Samples(const Body& body, std::array<double, 2> centre = {}) : centre_(centre) {
    for (std::size_t p = 0; p < body.size(); ++p) {
      const auto s = body.stress(p);
      const std::array<double, 6> row{body.x(0)[p], body.x(1)[p], body.volume()[p], s.xx, s.yy, s.xy};
      for (std::size_t k = 0; k < row.size(); ++k) column_[k].push_back(row[k]);
    }
  }
  operator mpm::analysis::StressSamples() const {
    return {.x = column_[0],
            .y = column_[1],
            .volume = column_[2],
            .xx = column_[3],
            .yy = column_[4],
            .xy = column_[5],
            .centre_x = centre_[0],
            .centre_y = centre_[1]};
  }

 private:
  std::array<double, 2> centre_;
  std::array<std::vector<double>, 6> column_;
};

/// Gives every particle the in-plane stress of `field(x, y)`, and the out-of-plane one of plane strain; in the law's
/// own state where more than the stress must agree with it.
template <class Body, class Field>
void set_stress(Body& body, double poisson, const Field& field) {
  for (std::size_t p = 0; p < body.size(); ++p) {
    const mpm::analysis::PlanarStress s = field(body.x(0)[p], body.x(1)[p]);
    const mpm::SymmetricTensor<double> stress{.xx = s.xx, .yy = s.yy, .zz = poisson * (s.xx + s.yy), .xy = s.xy};
    auto state = body.state(p);
    if constexpr (requires { body.law.state_of(stress); }) {
      state = body.law.state_of(stress);
    } else {
      state.stress = stress;
    }
    body.store(p, state);
  }
}

/// Rollers on the axes of a quarter model.
template <class Solver>
void roll_on_axes(Solver& solver) {
  for (int d = 0; d < 2; ++d) solver.boundary.face(d, 0) = mpm::Rollers<Plane>{};
}
/// The traction of `field` on the outer faces of a quarter model.
template <class Solver, class Field>
void pull_outer_faces(Solver& solver, const Field& field) {
  for (int d = 0; d < 2; ++d)
    solver.boundary.face(d, 1) = mpm::Traction<Plane>::on(solver.grid, d, 1, [&](const mpm::Vector<Plane>& x) {
      const mpm::analysis::PlanarStress s = field(x[0], x[1]);
      return d == 0 ? mpm::Vector<Plane>(s.xx, s.xy) : mpm::Vector<Plane>(s.xy, s.yy);
    });
}

}  // namespace holed_rock
