// SPDX-License-Identifier: MIT
#include "step.hpp"

namespace kernels {

void add_splines() {
  add<Linear, Hypoelastic, Usl>("linear");
  add<QuadraticBspline, Hypoelastic, Usl>("quadratic B-spline");
  add<CubicBspline, Hypoelastic, Usl>("cubic B-spline");
}

}  // namespace kernels
