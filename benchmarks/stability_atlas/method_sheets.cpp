// SPDX-License-Identifier: MIT
#include "method.hpp"
#include "sheets.hpp"

// Modes that ask for the particles of fills: every method brings them itself.
namespace mpm::atlas {
namespace {

/// All methods that know the mode of the sheet's name.
void add_methods(Sheet& sheet, bool quick) {
  for (const Method& method : methods())
    if (const auto mode = method.modes.find(sheet.name); mode != method.modes.end())
      mode->second(quick, [&](double x, double y) { sheet.points.push_back({method.shape, method.integrator, x, y}); });
}

}  // namespace

Sheet struck_bar_energy(bool quick) {
  Sheet sheet{"energy", "energy over ten periods"};
  sheet.title = std::string("A struck bar of ") + (quick ? "10" : "20") + " cells: change of its energy";
  sheet.x_label = "periods";
  sheet.y_label = "change of energy, %";
  sheet.at = "period ", sheet.limit = .05, sheet.percent = 100;
  add_methods(sheet, quick);
  return sheet;
}

Sheet checkerboard_decay(bool quick) {
  Sheet sheet{"checkerboard", "checkerboard stays"};
  sheet.title = "Velocities that alternate within each cell";
  sheet.x_label = "step";
  sheet.y_label = "kinetic energy left";
  sheet.at = "step ", sheet.limit = 1e-3, sheet.judged_from = 1000;
  add_methods(sheet, quick);
  return sheet;
}

Sheet shear_flow(bool quick) {
  Sheet sheet{"shear", "shear to 10"};
  sheet.title = "A block without stiffness in simple shear: where its particles are";
  sheet.x_label = "shear";
  sheet.y_label = "error of the displacement, %";
  sheet.at = "shear ", sheet.limit = .2, sheet.percent = 100;
  add_methods(sheet, quick);
  return sheet;
}

Sheet spin(bool quick) {
  Sheet sheet{"spin", "two turns: shape"};
  sheet.title = "A stiff block of 4 cells turns twice, its rim at .02 c: rms distance from its shape";
  sheet.x_label = "angle, degrees";
  sheet.y_label = "distance, cells";
  sheet.at = "degrees ", sheet.limit = .1;
  add_methods(sheet, quick);
  return sheet;
}

Sheet turn(bool quick) {
  Sheet sheet{"turn", "two turns: angle"};
  sheet.title = "A stiff block of 4 cells turns twice, its rim at .02 c: share of the angle that is lost";
  sheet.x_label = "angle, degrees";
  sheet.y_label = "angle lost, %";
  sheet.at = "degrees ", sheet.limit = .1, sheet.percent = 100;
  add_methods(sheet, quick);
  return sheet;
}

Sheet over_stretch(bool quick) {
  Sheet sheet{"over_stretch", "domains part when stretched to 20"};
  sheet.title = "A strip without stiffness drawn out: widest gap between neighbours";
  sheet.x_label = "stretch";
  sheet.y_label = "gap, of a domain's length";
  sheet.at = "stretch ", sheet.limit = .5;
  add_methods(sheet, quick);
  return sheet;
}

}  // namespace mpm::atlas
