// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include "fill.hpp"
#include "linear_step.hpp"

namespace mpm::atlas {

/// A shape and an integrator in a space, for fills.
struct FillMethod {
  std::string shape;       ///< "Cpdi"
  std::string integrator;  ///< "USL", "FMPM(2)", ...
  std::string space;       ///< "1-D", "2-D", "3-D", "radial", "axisymmetric"
  int dimension = 0;
  /// The linear step of a fill; none where `run` alone can tell.
  std::function<std::unique_ptr<LinearStep>(const Fill&, Random&)> linear{};
  /// Growth of the norm of random velocities, the largest in so many steps of the solver's own.
  std::function<double(const Fill&, Random&, int steps)> run{};

  std::string name() const { return space + ' ' + shape + ' ' + integrator; }
};

/// Everything shipped: shapes x integrators x spaces.
const std::vector<FillMethod>& fill_methods();
/// The one of that name. Throws std::out_of_range.
const FillMethod& fill_method(const std::string& space, const std::string& shape, const std::string& integrator);

// Those of one space.
std::vector<FillMethod> line_methods();
std::vector<FillMethod> plane_methods();
std::vector<FillMethod> spatial_methods();
std::vector<FillMethod> radial_methods();
std::vector<FillMethod> axisymmetric_methods();

}  // namespace mpm::atlas
