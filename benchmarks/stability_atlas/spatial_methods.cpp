// SPDX-License-Identifier: MIT
#include "fill_method_maker.hpp"

std::vector<mpm::atlas::FillMethod> mpm::atlas::spatial_methods() {
  return FillMethodMaker<Spatial<>>("3-D")
      .explicit_only<Linear>()
      .shape<Ugimp>()
      .explicit_only<Cpgimp>()
      .explicit_only<QuadraticBspline>()
      .explicit_only<CubicBspline>()
      .take();
}
std::vector<mpm::atlas::FillMethod> mpm::atlas::axisymmetric_methods() {
  return FillMethodMaker<Axisymmetric<>>("axisymmetric")
      .explicit_only<Ugimp>()
      .explicit_only<Cpdi>()
      .explicit_only<QuadraticBspline>()
      .take();
}
