// SPDX-License-Identifier: MIT
#pragma once
#include <accuracy_cost/methods.hpp>

namespace mpm::atlas {

/// Calls f<Shape>(name) for every shape that there is on a line.
template <class F>
void for_each_line_shape(const F& f) {
  const auto call = [&]<class Shape>() { f.template operator()<Shape>(accuracy_cost::shape_name<Shape>()); };
  call.template operator()<Linear>();
  call.template operator()<Ugimp>();
  call.template operator()<Cpgimp>();
  call.template operator()<Cpdi>();
  call.template operator()<QuadraticBspline>();
  call.template operator()<CubicBspline>();
}

}  // namespace mpm::atlas
