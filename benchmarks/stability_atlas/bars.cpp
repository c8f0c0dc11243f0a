// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <cmath>
#include "modes/checkerboard.hpp"
#include "modes/relaxed_bar.hpp"
#include "modes/struck_bar.hpp"
#include "modes/torn.hpp"
#include "sheets.hpp"

// Modes of a bar.
namespace mpm::atlas {
namespace {

/// Calls f(name, integrator) for the integrators that the sheets compare.
template <class F>
void for_integrators(const F& f) {
  f("USF", Usf{});
  f("USL", Usl{});
  f("MUSL", Musl{});
  f("MUSL PIC", Musl{.flip = 0});
  f("MUSL FLIP .99", Musl{.flip = .99});
  f("FMPM(2)", Fmpm{.order = 2});
  f("FMPM(4)", Fmpm{.order = 4});
  f("full-mass FLIP(2)", FullMassFlip{.order = 2});
  f("APIC", Apic{});
}

}  // namespace

Sheet numerical_fracture(bool quick) {
  Sheet sheet{"fracture", "stretched bar tears"};
  sheet.title = "A bar drawn out evenly, 2 particles a cell at first";
  sheet.x_label = "stretch";
  sheet.y_label = "pairs of neighbours that share no node";
  sheet.at = "stretch ", sheet.log_y = false;
  const auto add = [&]<class Shape>(const char* method) {
    for (double stretch = 1; stretch <= 20; stretch += quick ? .5 : .2)
      sheet.points.push_back({method, stretch, torn<Shape>(stretch)});
  };
  add.operator()<Linear>("Linear USL");
  add.operator()<Ugimp>("Ugimp USL");
  add.operator()<Cpgimp>("Cpgimp USL");
  add.operator()<Cpdi>("Cpdi USL");
  add.operator()<QuadraticBspline>("QuadraticBspline USL");
  add.operator()<CubicBspline>("CubicBspline USL");
  return sheet;
}

Sheet struck_bar_energy(bool quick) {
  const int cells = quick ? 10 : 20;
  Sheet sheet{"energy", "energy over ten periods"};
  sheet.title = "A struck bar of " + std::to_string(cells) + " cells, CPDI, step .4 h/c: change of its energy";
  sheet.x_label = "periods";
  sheet.y_label = "change of energy, %";
  sheet.at = "period ", sheet.limit = .05, sheet.percent = 100;
  for_integrators([&](const char* name, const auto& integrator) {
    double next = 0;
    struck_bar<Cpdi>(integrator, cells, [&](double periods, double change) {
      if (periods < next) return;
      sheet.points.push_back({std::string("Cpdi ") + name, periods, std::abs(change)});
      next += .25;
    });
  });
  return sheet;
}

Sheet checkerboard_decay(bool) {
  Sheet sheet{"checkerboard", "checkerboard stays"};
  sheet.title = "Velocities that alternate within each cell, linear shapes";
  sheet.x_label = "step";
  sheet.y_label = "kinetic energy left";
  sheet.at = "step ", sheet.limit = 1e-3, sheet.judged_from = 1000;
  for_integrators([&](const char* name, const auto& integrator) {
    checkerboard<Linear>(integrator, [&](int step, double share) {
      if (step % 50 == 0 || step < 5)
        sheet.points.push_back({std::string("Linear ") + name, double(step), std::max(share, 1e-30)});
    });
  });
  return sheet;
}

Sheet relaxation_stop(bool) {
  Sheet sheet{"relaxation", "relaxation stops too soon"};
  sheet.title = "A pulled bar, relaxed: error of its stress where the relaxation stops";
  sheet.x_label = "damping, of the critical one";
  sheet.y_label = "error of the stress, %";
  sheet.at = "damping ", sheet.limit = .05, sheet.percent = 100, sheet.log_x = true;
  for (const double share : {.1, .3, 1., 3., 10.}) {
    sheet.points.push_back(
        {"fixed damping: kinetic energy alone", share, std::abs(RelaxedBar<Damping::fixed>(share).when_slow().error)});
    sheet.points.push_back(
        {"fixed damping: mpm::relax", share, std::abs(RelaxedBar<Damping::fixed>(share).at_rest().error)});
  }
  sheet.points.push_back(
      {"adaptive damping: mpm::relax", 1, std::abs(RelaxedBar<Damping::adaptive>().at_rest().error)});
  return sheet;
}

}  // namespace mpm::atlas
