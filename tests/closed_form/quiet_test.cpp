// SPDX-License-Identifier: MIT
#include <problems/holed_rock.hpp>
#include <gtest/gtest.h>

// Relaxed rock moved to an explicit solver whose faces are quiet and hold their reactions: without a charge nothing may
// happen.
namespace {

using namespace mpm::problems;
using Plane = mpm::PlaneStrain<>;
using mpm::analysis::Kirsch;

constexpr double side = 8, cells = 2;
constexpr Kirsch in_situ{.horizontal = -10e6, .vertical = -40e6, .radius = hole};

mpm::analysis::PlanarStress exact(double x, double y) {
  return in_situ.stress(x, y);
}
template <class Law>
auto relaxed(mpm::Body<mpm::CpdiQuad, Law> body) {
  mpm::Solver<mpm::CpdiQuad, Law, mpm::DynamicRelaxation<>> solver(holed_block_grid(side, cells), std::move(body));
  roll_on_axes(solver);
  pull_outer_faces(solver, exact);
  mpm::relax(solver, {.tolerance = 1e-10});
  return std::move(solver.body());
}

/// Largest change of a stress component over five crossings of the block with outer faces `face`, in the larger
/// far-field stress.
template <class Law, class Face>
double drift(mpm::Body<mpm::CpdiQuad, Law> body, const Face& face) {
  mpm::Solver<mpm::CpdiQuad, Law, mpm::Musl> solver(holed_block_grid(side, cells), std::move(body));
  roll_on_axes(solver);
  const double density = solver.body().law.density;
  const mpm::Moduli<double> moduli =
      solver.body().law.tangent(solver.body().state(0), solver.body().relative_volume(0));
  for (int d = 0; d < 2; ++d) solver.boundary.face(d, 1) = face(density, moduli);
  solver.hold_quiet_faces();
  std::vector<mpm::SymmetricTensor<double>> before;
  for (std::size_t p = 0; p < solver.body().size(); ++p) before.push_back(solver.body().stress(p));
  const double speed = std::sqrt(moduli.longitudinal / density);
  double worst = 0;
  solver.run(5 * side * hole / speed, [&](auto& s) {
    for (std::size_t p = 0; p < before.size(); ++p) {
      const auto change = s.body().stress(p) - before[p];
      worst = std::max(worst, std::sqrt(inner(change, change)));
    }
  });
  return worst / std::abs(in_situ.vertical);
}

const auto dashpots = [](double density, const mpm::Moduli<double>& moduli) {
  return mpm::Quiet<Plane>::from(density, moduli);
};
const auto springs_too = [](double density, const mpm::Moduli<double>& moduli) {
  return mpm::ViscousSpring<Plane>::from(density, moduli, {0, 0});
};

TEST(QuietFaces, HoldElasticRock) {
  const auto rock = mpm::granite_elastic();
  auto body = mpm::geometry::make_body("rock", holed_block(side, cells).mesh(), rock);
  set_stress(body, rock.poisson, exact);
  body = relaxed(std::move(body));
  EXPECT_LT(drift(body, dashpots), 1e-7);
  EXPECT_LT(drift(body, springs_too), 1e-7);
}

TEST(QuietFaces, HoldJohnsonHolmquistRock) {
  const auto rock = mpm::granite_paper();
  const auto J = [&](const mpm::geometry::Point& x) {
    const auto s = exact(x[0], x[1]);
    return rock.relative_volume(-(1 + rock.poisson) * (s.xx + s.yy) / 3);
  };
  auto body = mpm::geometry::make_body("rock", holed_block(side, cells).mesh(), rock, J);
  set_stress(body, rock.poisson, exact);
  body = relaxed(std::move(body));
  EXPECT_LT(drift(body, dashpots), 1e-7);
  EXPECT_LT(drift(body, springs_too), 1e-7);
}

}  // namespace
