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

// What the problems of a blast hole's rock share: the paper's hole, rock with it, and the particles' stresses.
namespace mpm::problems {

using geometry::Model;
constexpr double hole = 0.021;  ///< the hole's radius a of Xiao et al. 2024, m

/// The block of `side` radii half side with `per_edge` particles an edge of a cell of `a / cells` m.
inline geometry::HoledBlock holed_block(double side, double cells, int per_edge = 2, Model model = Model::quarter) {
  return {.radius = hole, .half_side = side * hole, .particle_size = hole / (per_edge * cells), .model = model};
}

/// The grid that ends on the block's faces.
template <class Space = PlaneStrain<>>
Grid<Space> holed_block_grid(double side, double cells, Model model = Model::quarter) {
  using Scalar = typename Space::Scalar;
  const int half = int(std::lround(side * cells));
  const Scalar cell = Scalar(hole / cells), low = Scalar(-side * hole);
  if (model == Model::quarter) return {{0, 0}, cell, {half, half}};
  return {{low, low}, cell, {2 * half, 2 * half}};
}

/// Copies of the stresses of the particles between two radii about `centre`, as the read-outs take them. Particles of
/// the radial space stand at 0 degrees, where the hoop stress is the one along y; of three axes z is along the hole.
class Samples {
 public:
  template <class Body>
  Samples(const Body& body, double inner, double outer, std::array<double, 2> centre = {}) : centre_(centre) {
    constexpr bool radial = Body::dimension == 1;
    for (std::size_t p = 0; p < body.size(); ++p) {
      const double x = double(body.x(0)[p]), y = radial ? 0 : double(body.x(Body::dimension > 1)[p]);
      const double r = std::hypot(x - centre[0], y - centre[1]);
      if (r < inner || r > outer) continue;
      const auto s = body.stress(p);
      const std::array<double, 6> row{
          x, y, double(body.volume()[p]), double(s.xx), double(radial ? s.zz : s.yy), double(s.xy)};
      for (std::size_t k = 0; k < row.size(); ++k) column_[k].push_back(row[k]);
    }
  }
  operator analysis::StressSamples() const {
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
  using Scalar = typename Body::Scalar;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const analysis::PlanarStress s = field(double(body.x(0)[p]), double(body.x(1)[p]));
    const SymmetricTensor<Scalar> stress{
        .xx = Scalar(s.xx), .yy = Scalar(s.yy), .zz = Scalar(poisson * (s.xx + s.yy)), .xy = Scalar(s.xy)};
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
  using Space = PlaneStrain<typename Solver::Scalar>;
  for (int d = 0; d < 2; ++d) solver.boundary.face(d, 0) = Rollers<Space>{};
}
/// The traction of `field` on the outer faces of a quarter model.
template <class Solver, class Field>
void pull_outer_faces(Solver& solver, const Field& field) {
  using Space = PlaneStrain<typename Solver::Scalar>;
  for (int d = 0; d < 2; ++d)
    solver.boundary.face(d, 1) = Traction<Space>::on(solver.grid, d, 1, [&](const Vector<Space>& x) {
      const analysis::PlanarStress s = field(double(x[0]), double(x[1]));
      using Scalar = typename Space::Scalar;
      return d == 0 ? Vector<Space>(Scalar(s.xx), Scalar(s.xy)) : Vector<Space>(Scalar(s.xy), Scalar(s.yy));
    });
}

}  // namespace mpm::problems
