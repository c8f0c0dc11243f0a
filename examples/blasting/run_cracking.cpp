// SPDX-License-Identifier: MIT
#include "simulation.hpp"

template void blasting::run_with<blasting::Rock<blasting::CrackingRock>>(const Scene&, const Options&);
