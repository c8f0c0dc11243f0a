// SPDX-License-Identifier: MIT
#include "method_maker.hpp"

std::vector<mpm::atlas::Method> mpm::atlas::plane_methods() {
  return MethodMaker<PlaneStrain<>>("2-D")
      .shape<Linear>()
      .shape<Ugimp>()
      .shape<Cpgimp>()
      .shape<Cpdi>()
      .shape<CpdiQuad>()
      .shape<QuadraticBspline>()
      .shape<CubicBspline>()
      .take();
}
