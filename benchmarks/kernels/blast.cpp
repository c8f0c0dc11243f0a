// SPDX-License-Identifier: MIT
#include "step.hpp"
#include <blasting/last_good.hpp>
#include <blasting/stages.hpp>
#include <mpm/energy_guard.hpp>

namespace kernels {
namespace {

/// The default scene's rock under its in-situ stress, charge and air, from the blast on: 100 us, in float;
/// `guarded`: with the guards that the program sets on it, of energy and the copy of the last good state.
template <bool guarded>
void blast(benchmark::State& state) {
  program::use_threads(int(state.range(0)));
  using Rock = blasting::Rock<blasting::CrackingRock, CpdiQuad, float>;
  blasting::Scene scene;
  const auto rock = blasting::make_rock<Rock>(scene);
  std::int64_t particle_steps = 0;
  for (auto _ : state) {
    state.PauseTiming();
    auto solver = blasting::blast_stage<Rock, Musl>(scene, rock);
    EnergyGuard guard;
    blasting::LastGood<decltype(solver)> last_good(scene, ".");
    if (guarded) last_good.keep(solver);  // once a run: brings the memory of the copy
    state.ResumeTiming();
    while (solver.time < 100e-6) {
      solver.step();
      if constexpr (guarded) guard(solver), last_good.keep(solver);
    }
    particle_steps +=
        solver.steps * std::int64_t(solver.body<0>().size() + solver.body<1>().size() + solver.body<2>().size());
  }
  using Blasted = typename blasting::BlastSolver<Rock, Musl>::template BodyAt<0>;
  state.counters["bytes"] = double(Blasted::bytes_per_particle);
  state.counters["flops"] = transfer_flops(rock, blasting::background<blasting::Space>(scene));
  state.SetItemsProcessed(particle_steps);
}

}  // namespace

void add_blast() {
  const auto add = [](const char* name, void (*f)(benchmark::State&), int most_threads) {
    benchmark::RegisterBenchmark(name, f)
        ->ArgName("threads")
        ->DenseRange(1, most_threads)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1)
        ->Repetitions(3);  // the table keeps the fastest
  };
  add("the default blast to 100 us", blast<false>, 2);
  add("the same, guarded", blast<true>, 1);
}

}  // namespace kernels
