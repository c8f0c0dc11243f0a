// SPDX-License-Identifier: MIT
#include "fill_method_maker.hpp"

std::vector<mpm::atlas::FillMethod> mpm::atlas::line_methods() {
  return FillMethodMaker<Uniaxial<>>("1-D")
      .shape<Linear>()
      .shape<Ugimp>()
      .shape<Cpgimp>()
      .shape<Cpdi>()
      .shape<QuadraticBspline>()
      .shape<CubicBspline>()
      .add<Ugimp>("relaxation", DynamicRelaxation<>{})
      .take();
}
std::vector<mpm::atlas::FillMethod> mpm::atlas::radial_methods() {
  return FillMethodMaker<Radial<>>("radial")
      .explicit_only<Ugimp>()
      .explicit_only<Cpdi>()
      .explicit_only<QuadraticBspline>()
      .take();
}
