// SPDX-License-Identifier: MIT
#include "step.hpp"

namespace kernels {

void add_ugimp() {
  add<Ugimp, Hypoelastic, Usl>("uGIMP");
  for (const int n : {100, 10000, 1000000, 4000000})
    add<Ugimp, Hypoelastic, Usl>("uGIMP, " + std::to_string(n) + " particles",
                                 {.particles = n, .layouts = {Layout::regular}});
  for (const int edge : {4, 20})
    add<Ugimp, Hypoelastic, Usl>("uGIMP, " + std::to_string(edge) + " an edge", {.per_edge = edge});
  add<Ugimp, Hypoelastic, Usl>("uGIMP, numbered at random", {.layouts = {Layout::shuffled}});
  add<Ugimp, Hypoelastic, Usl>("uGIMP, a cell in 20 steps", {.drift = .1, .steps_between = 30});
  add<Ugimp, Hypoelastic, Usl>("uGIMP, in a grid of 100 times its area", {.room = 10, .layouts = {Layout::regular}});
  add<Ugimp, Hypoelastic, Usl>("uGIMP, 2 threads", {.threads = 2});
  add<Ugimp, Hypoelastic, Musl>("uGIMP, MUSL");
  add<Ugimp, Hypoelastic, Fmpm>("uGIMP, FMPM(2)");
  add<Ugimp, Hypoelastic, Fmpm>("uGIMP, FMPM(4)", {.integrator = {.order = 4}});
  add<Ugimp, Hypoelastic, Apic>("uGIMP, APIC");
}

}  // namespace kernels
