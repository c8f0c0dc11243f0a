// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>
#include "fill.hpp"
#include "resting_step.hpp"

namespace mpm::atlas {

/// Takes the points of a curve one by one.
using Curve = std::function<void(double x, double y)>;

/// A shape and an integrator in a space.
struct Method {
  std::string shape;       ///< "Cpdi"
  std::string integrator;  ///< "USL", "FMPM(2)", ...
  std::string space;       ///< "1-D", "2-D", "3-D", "radial", "axisymmetric"
  int dimension = 0;
  /// Whether all that a step hands on to the next is the particles' velocities and stresses, so that the step of a fill
  /// at rest is a matrix.
  bool has_matrix = false;
  /// The step of a fill at rest.
  std::function<std::unique_ptr<RestingStep>(const Fill&, Random&)> at_rest{};
  /// Growth of the norm of random velocities, the largest in so many steps of the solver's own.
  std::function<double(const Fill&, Random&, int steps)> run{};
  /// Ways to fail that ask for the particles of fills, by the name of their sheet; coarser if quick.
  std::map<std::string, std::function<void(bool quick, const Curve&)>> modes{};

  std::string name() const { return space + ' ' + shape + ' ' + integrator; }
};

/// Everything shipped: in 1-D and 2-D every shape with every integrator and transfer, elsewhere what differs there.
const std::vector<Method>& methods();
/// The one of that name. Throws std::out_of_range.
const Method& find_method(const std::string& space, const std::string& shape, const std::string& integrator);

// Those of one space.
std::vector<Method> line_methods();
std::vector<Method> plane_methods();
std::vector<Method> spatial_methods();
std::vector<Method> radial_methods();
std::vector<Method> axisymmetric_methods();

}  // namespace mpm::atlas
