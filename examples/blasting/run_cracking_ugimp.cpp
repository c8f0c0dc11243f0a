// SPDX-License-Identifier: MIT
#include "simulation.hpp"

template void blasting::run_with<blasting::Rock<blasting::CrackingRock, mpm::Ugimp>>(const Scene&, const Options&);
