// SPDX-License-Identifier: MIT
#include "method_maker.hpp"

std::vector<mpm::atlas::Method> mpm::atlas::line_methods() {
  return MethodMaker<Uniaxial<>>("1-D")
      .shape<Linear>()
      .shape<Ugimp>()
      .shape<Cpgimp>()
      .shape<Cpdi>()
      .shape<QuadraticBspline>()
      .shape<CubicBspline>()
      .take();
}
std::vector<mpm::atlas::Method> mpm::atlas::radial_methods() {
  return MethodMaker<Radial<>>("radial")
      .explicit_only<Ugimp>()
      .explicit_only<Cpdi>()
      .explicit_only<QuadraticBspline>()
      .take();
}
