// SPDX-License-Identifier: MIT
#pragma once
#include "claims.hpp"
#include <vector>

namespace paper {

/// The twelve states, of which two are one: eleven.
std::vector<State> all_states();

/// "h10-v40".
std::string name_of(const State& state);

/// The paper's scene under a state, the full plane; on cells and particles of twice the size if `coarse`.
blasting::Scene scene_of(const State& state, bool coarse);

/// A quarter on the coarse cells, cheap enough to be run for several seeds.
blasting::Scene coarse_quarter(const State& state, int seed);

}  // namespace paper
