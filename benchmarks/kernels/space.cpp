// SPDX-License-Identifier: MIT
#include "step.hpp"

namespace kernels {

void add_space() {
  add<Ugimp, Hypoelastic, Usl, PlaneStrain<float>>("uGIMP, float");
  add<Ugimp, Hypoelastic, Usl, Spatial<>>("uGIMP, 3-D");
}

}  // namespace kernels
