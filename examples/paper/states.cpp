// SPDX-License-Identifier: MIT
#include "states.hpp"

namespace paper {

std::vector<State> all_states() {
  std::vector<State> states;
  for (const double level : equiaxial_levels) states.push_back({level, level});
  for (const double k : lateral_ratios)
    if (k != 1) states.push_back({k * vertical_stress, vertical_stress});
  return states;
}

std::string name_of(const State& state) {
  return "h" + fixed(state.first, 0) + "-v" + fixed(state.second, 0);
}

blasting::Scene scene_of(const State& state, bool coarse) {
  blasting::Scene scene;
  scene.model = blasting::Model::full;
  if (coarse) scene.grid.cell = .02, scene.rock.particle = .01;
  scene.stress.horizontal = 1e6 * state.first, scene.stress.vertical = 1e6 * state.second;
  scene.output = {.snapshots = 0, .probes = {.1, .2, .4, probe_radius}};
  return scene;
}

blasting::Scene coarse_quarter(const State& state, int seed) {
  auto scene = scene_of(state, true);
  scene.model = blasting::Model::quarter;
  scene.seed = seed;
  return scene;
}

}  // namespace paper
