// SPDX-License-Identifier: MIT
#include "simulation.hpp"

template void blasting::run_with<blasting::CrushingRock>(const Scene&, const Options&);
