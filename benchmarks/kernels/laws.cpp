// SPDX-License-Identifier: MIT
#include "step.hpp"
#include <mpm/materials/presets.hpp>

namespace kernels {

void add_laws() {
  add<CpdiQuad, JohnsonHolmquist2, Usl>("CPDI2, JH-2, damaging", {.damaging = true});
  add<Ugimp, JonesWilkinsLee, Usl>("uGIMP, JWL gas, 4 an edge",
                                   {.per_edge = 4, .law = petn_1260(), .steps_between = 10});
}

}  // namespace kernels
