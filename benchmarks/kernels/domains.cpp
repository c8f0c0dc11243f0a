// SPDX-License-Identifier: MIT
#include "step.hpp"

namespace kernels {

void add_domains() {
  add<Cpgimp, Hypoelastic, Usl>("cpGIMP");
  add<Cpdi, Hypoelastic, Usl>("CPDI R4");
  add<CpdiQuad, Hypoelastic, Usl>("CPDI2");
  add<CpdiQuad, Hypoelastic, Usl>("CPDI2, numbered at random", {.layouts = {Layout::shuffled}});
}

}  // namespace kernels
