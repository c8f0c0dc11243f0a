// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <cmath>
#include <limits>
#include "modes/cook.hpp"
#include "sheets.hpp"

// Cook's membrane, hardly compressible.
namespace mpm::atlas {

Sheet locking(bool quick) {
  Sheet sheet{"locking", "locking at nu .499"};
  sheet.title = "Cook's membrane at nu .499: how far its deflection is from that of finite elements";
  sheet.x_label = "cells along the panel";
  sheet.y_label = "error of the deflection, %";
  sheet.at = "cells: ", sheet.limit = .1, sheet.percent = 100;
  sheet.judged_from = quick ? 12 : 16;
  const auto add = [&]<class Shape>() {
    for (const double cell : quick ? std::vector{8., 4.} : std::vector{8., 4., 3.})
      for (const double poisson : {.3, .499}) {
        double error = std::numeric_limits<double>::infinity();
        try {
          error = std::abs(cook<Shape>({.poisson = poisson, .cell = cell}) - 1);
        } catch (const Error&) {
        }
        sheet.points.push_back(
            {accuracy_cost::shape_name<Shape>() + (poisson < .4 ? " USL at nu .3" : " USL"), 48 / cell, error});
      }
  };
  add.operator()<Linear>();
  add.operator()<Ugimp>();
  add.operator()<MeanDilatation<Ugimp>>();
  add.operator()<QuadraticBspline>();
  add.operator()<CubicBspline>();
  return sheet;
}

}  // namespace mpm::atlas
