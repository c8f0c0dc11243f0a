// SPDX-License-Identifier: MIT
#include "method_maker.hpp"

std::vector<mpm::atlas::Method> mpm::atlas::spatial_methods() {
  return MethodMaker<Spatial<>>("3-D")
      .explicit_only<Linear>()
      .shape<Ugimp>()
      .explicit_only<Cpgimp>()
      .explicit_only<QuadraticBspline>()
      .explicit_only<CubicBspline>()
      .take();
}
std::vector<mpm::atlas::Method> mpm::atlas::axisymmetric_methods() {
  return MethodMaker<Axisymmetric<>>("axisymmetric")
      .explicit_only<Ugimp>()
      .explicit_only<Cpdi>()
      .explicit_only<QuadraticBspline>()
      .take();
}
