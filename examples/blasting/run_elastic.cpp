// SPDX-License-Identifier: MIT
#include "simulation.hpp"

template void blasting::run_with<blasting::Rock<blasting::ElasticRock>>(const Scene&, const Options&);
