// SPDX-License-Identifier: MIT
#include "fill_method_maker.hpp"

std::vector<mpm::atlas::FillMethod> mpm::atlas::plane_methods() {
  return FillMethodMaker<PlaneStrain<>>("2-D")
      .explicit_only<Linear>()
      .shape<Ugimp>()
      .explicit_only<Cpgimp>()
      .explicit_only<Cpdi>()
      .shape<CpdiQuad>()
      .shape<QuadraticBspline>()
      .explicit_only<CubicBspline>()
      .add<CpdiQuad>("relaxation", DynamicRelaxation<>{})
      .take();
}
