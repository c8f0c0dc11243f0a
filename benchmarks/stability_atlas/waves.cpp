// SPDX-License-Identifier: MIT
#include <problems/axis_aligned.hpp>
#include <limits>
#include "integrators.hpp"
#include "line_shapes.hpp"
#include "sheets.hpp"

// The manufactured waves along an axis: how large, and with how many particles.
namespace mpm::atlas {
namespace {

template <class Shape, class Integrator>
double error(const problems::AxisAlignedOptions& options, const Integrator& integrator) {
  try {
    return problems::axis_aligned<1, Shape>(options, integrator).error;
  } catch (const Error&) {
    return std::numeric_limits<double>::infinity();
  }
}

/// Calls f<Shape>(shape, name, integrator) for all.
template <class F>
void for_each_method(const F& f) {
  for_each_line_shape([&]<class Shape>(const std::string& shape) {
    for_each_integrator(
        [&](const char* name, const auto& integrator) { f.template operator()<Shape>(shape, name, integrator); });
  });
}

}  // namespace

Sheet growing_amplitude(bool quick) {
  const int cells = quick ? 32 : 64;
  Sheet sheet{"amplitude", "growing amplitude"};
  sheet.title = "Manufactured wave, " + std::to_string(cells) + " cells, 2 particles each: cell crossing and stretch";
  sheet.x_label = "amplitude A, m, of 1 m";
  sheet.y_label = "error of the displacement, %";
  sheet.at = "A = ";
  sheet.limit = .02, sheet.percent = 100, sheet.log_x = true;
  for_each_method([&]<class Shape>(const std::string& shape, const char* name, const auto& integrator) {
    for (const double A : {.0005, .002, .005, .01, .02, .05, .1, .15, .2})
      sheet.points.push_back({shape, name, A, error<Shape>({.cells = cells, .amplitude = A}, integrator)});
  });
  return sheet;
}

Sheet particles_a_cell(bool quick) {
  const int cells = quick ? 32 : 64;
  Sheet sheet{"particles", "few particles a cell"};
  sheet.title = "Manufactured wave, A = .05 m, " + std::to_string(cells) + " cells, by particles a cell";
  sheet.x_label = "particles a cell";
  sheet.y_label = "error of the displacement, %";
  sheet.limit = .02, sheet.percent = 100;
  for_each_method([&]<class Shape>(const std::string& shape, const char* name, const auto& integrator) {
    for (const int n : {8, 4, 3, 2, 1})
      sheet.points.push_back({shape, name, double(n), error<Shape>({.cells = cells, .per_edge = n}, integrator)});
  });
  return sheet;
}

}  // namespace mpm::atlas
