// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <cmath>
#include <limits>
#include "modes/cook.hpp"
#include "sheets.hpp"

// Cook's membrane, compressible and hardly so.
namespace mpm::atlas {
namespace {

void add_shapes(Sheet& sheet, double poisson, bool quick) {
  sheet.x_label = "cells along the panel";
  sheet.y_label = "error of the deflection, %";
  sheet.at = "cells: ", sheet.limit = .1, sheet.percent = 100;
  sheet.judged_from = quick ? 12 : 16;
  const auto add = [&]<class Shape>() {
    for (const double cell : quick ? std::vector{8., 4.} : std::vector{8., 4., 3.}) {
      double error = std::numeric_limits<double>::infinity();
      try {
        error = std::abs(cook<Shape>({.poisson = poisson, .cell = cell}) - 1);
      } catch (const Error&) {
      }
      sheet.points.push_back({accuracy_cost::shape_name<Shape>(), "relaxation", 48 / cell, error});
    }
  };
  add.operator()<Linear>();
  add.operator()<Ugimp>();
  add.operator()<MeanDilatation<Ugimp>>();
  add.operator()<Cpgimp>();
  add.operator()<Cpdi>();
  add.operator()<CpdiQuad>();
  add.operator()<QuadraticBspline>();
  add.operator()<CubicBspline>();
}

}  // namespace

Sheet locking(bool quick) {
  Sheet sheet{"locking", "locking at nu .499"};
  sheet.title = "Cook's membrane at nu .499: how far its deflection is from that of finite elements";
  add_shapes(sheet, .499, quick);
  return sheet;
}

Sheet bending(bool quick) {
  Sheet sheet{"bending", "the same at nu .3"};
  sheet.title = "Cook's membrane at nu .3: how far its deflection is from that of finite elements";
  add_shapes(sheet, .3, quick);
  return sheet;
}

}  // namespace mpm::atlas
