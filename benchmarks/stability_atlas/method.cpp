// SPDX-License-Identifier: MIT
#include "method.hpp"
#include <algorithm>
#include <stdexcept>

namespace mpm::atlas {

const std::vector<Method>& methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> list;
    for (const auto& make : {line_methods, plane_methods, spatial_methods, radial_methods, axisymmetric_methods})
      for (Method& m : make()) list.push_back(std::move(m));
    return list;
  }();
  return all;
}

const Method& find_method(const std::string& space, const std::string& shape, const std::string& integrator) {
  const auto found = std::ranges::find_if(
      methods(), [&](const Method& m) { return m.space == space && m.shape == shape && m.integrator == integrator; });
  if (found == methods().end()) throw std::out_of_range("no method " + space + ' ' + shape + ' ' + integrator);
  return *found;
}

}  // namespace mpm::atlas
