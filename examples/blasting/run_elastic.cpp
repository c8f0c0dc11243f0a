// SPDX-License-Identifier: MIT
#include "simulation.hpp"

template void blasting::run_with<blasting::ElasticRock>(const Scene&, const Options&);
