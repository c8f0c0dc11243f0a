// SPDX-License-Identifier: MIT
#include "simulation.hpp"

template void blasting::run_with<blasting::Rock<blasting::CrackingRock, mpm::CpdiQuad, float>>(const Scene&,
                                                                                               const Options&);
