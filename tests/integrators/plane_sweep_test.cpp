// SPDX-License-Identifier: MIT
#include "integrator_sweep.hpp"

namespace mpm::integrator_laws {
INSTANTIATE_TYPED_TEST_SUITE_P(Plane, IntegratorSweep, PlaneCombinations);
}  // namespace mpm::integrator_laws
