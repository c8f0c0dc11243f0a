// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include "line_shapes.hpp"
#include "modes/relaxed_bar.hpp"
#include "modes/torn.hpp"
#include "sheets.hpp"

// Modes of a bar in which the shape alone tells, or the relaxation.
namespace mpm::atlas {

Sheet numerical_fracture(bool quick) {
  Sheet sheet{"fracture", "stretched bar tears"};
  sheet.title = "A bar drawn out evenly, 2 particles a cell at first";
  sheet.x_label = "stretch";
  sheet.y_label = "pairs of neighbours that share no node";
  sheet.at = "stretch ", sheet.log_y = false;
  for_each_line_shape([&]<class Shape>(const std::string& shape) {
    for (double stretch = 1; stretch <= 20; stretch += quick ? .5 : .2)
      sheet.points.push_back({shape, "", stretch, torn<Shape>(stretch)});
  });
  return sheet;
}

Sheet relaxation_stop(bool) {
  Sheet sheet{"relaxation", "relaxation stops too soon"};
  sheet.title = "A pulled bar, relaxed: error of its stress where the relaxation stops";
  sheet.x_label = "damping, of the critical one";
  sheet.y_label = "error of the stress, %";
  sheet.at = "damping ", sheet.limit = .05, sheet.percent = 100, sheet.log_x = true;
  for_each_line_shape([&]<class Shape>(const std::string& shape) {
    const auto add = [&](const char* how, double share, const auto& rest) {
      double error = std::numeric_limits<double>::infinity();
      try {
        error = std::abs(rest().error);
      } catch (const Error&) {
      }
      sheet.points.push_back({shape, how, share, error});
    };
    using Fixed = RelaxedBar<Shape, Damping::fixed>;
    for (const double share : {.1, .3, 1., 3., 10.}) {
      add("fixed damping by kinetic energy", share, [&] { return Fixed(share).when_slow(); });
      add("fixed damping", share, [&] { return Fixed(share).at_rest(); });
    }
    add("relaxation", 1, [&] { return RelaxedBar<Shape, Damping::adaptive>().at_rest(); });
  });
  return sheet;
}

}  // namespace mpm::atlas
