// SPDX-License-Identifier: MIT
#include "step.hpp"
#include <blasting/stages.hpp>

namespace kernels {
namespace {

/// The default scene's rock under its in-situ stress, charge and air, from the blast on: 100 us, block of 3 m.
void blast(benchmark::State& state) {
  program::use_threads(int(state.range(0)));
  using Rock = blasting::CrackingRock;
  blasting::Scene scene;
  const auto rock = blasting::make_rock<Rock>(scene);
  std::int64_t particle_steps = 0;
  for (auto _ : state) {
    state.PauseTiming();
    auto solver = blasting::blast_stage<Rock, Usl>(scene, rock);
    state.ResumeTiming();
    while (solver.time < 100e-6) solver.step();
    particle_steps +=
        solver.steps * std::int64_t(solver.body<0>().size() + solver.body<1>().size() + solver.body<2>().size());
  }
  state.counters["bytes"] = double(rock.bytes_per_particle);
  state.counters["flops"] = transfer_flops(rock, blasting::background(scene));
  state.SetItemsProcessed(particle_steps);
}

}  // namespace

void add_blast() {
  benchmark::RegisterBenchmark("the default blast to 100 us", blast)
      ->ArgName("threads")
      ->Arg(1)
      ->Arg(2)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
}

}  // namespace kernels
