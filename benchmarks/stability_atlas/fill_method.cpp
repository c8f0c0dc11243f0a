// SPDX-License-Identifier: MIT
#include "fill_method.hpp"
#include <algorithm>
#include <stdexcept>

namespace mpm::atlas {

const std::vector<FillMethod>& fill_methods() {
  static const std::vector<FillMethod> all = [] {
    std::vector<FillMethod> methods;
    for (const auto& make : {line_methods, plane_methods, spatial_methods, radial_methods, axisymmetric_methods})
      for (FillMethod& m : make()) methods.push_back(std::move(m));
    return methods;
  }();
  return all;
}

const FillMethod& fill_method(const std::string& space, const std::string& shape, const std::string& integrator) {
  const auto found = std::ranges::find_if(fill_methods(), [&](const FillMethod& m) {
    return m.space == space && m.shape == shape && m.integrator == integrator;
  });
  if (found == fill_methods().end()) throw std::out_of_range("no method " + space + ' ' + shape + ' ' + integrator);
  return *found;
}

}  // namespace mpm::atlas
