// SPDX-License-Identifier: MIT
#include "integrator_sweep.hpp"

namespace mpm::integrator_laws {
INSTANTIATE_TYPED_TEST_SUITE_P(Uniaxial, IntegratorSweep, UniaxialCombinations);
}  // namespace mpm::integrator_laws
