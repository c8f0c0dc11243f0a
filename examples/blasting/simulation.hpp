// SPDX-License-Identifier: MIT
#pragma once
#include "last_good.hpp"
#include "progress.hpp"
#include "recorder.hpp"
#include "run.hpp"
#include "stages.hpp"
#include <mpm/analysis/state_hash.hpp>
#include <mpm/energy_guard.hpp>
#include <mpm/relax.hpp>
#include <program/threads.hpp>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

namespace blasting {
namespace detail {

using Clock = std::chrono::steady_clock;
inline double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// What a run has taken since this was made.
struct Cost {
  Clock::time_point begin = Clock::now();
  std::clock_t processor = std::clock();
  void write(Summary& summary) const {
    summary.wall_seconds = seconds_since(begin);
    summary.cpu_seconds = double(std::clock() - processor) / CLOCKS_PER_SEC;
  }
};

/// Energy of the charge, J per metre of the full plane.
template <class Body>
double energy_of(const Body& charge, const Scene& scene) {
  double sum = 0;
  for (std::size_t p = 0; p < charge.size(); ++p) sum += charge.mass()[p] / charge.law.density * charge.state(p).energy;
  return multiplicity(scene) * sum;
}

/// Stage 1: relaxes the rock; the report goes into the summary.
template <class Rock>
typename Rock::Body relax_rock(const Scene& scene, const std::filesystem::path& folder, Summary& summary) {
  auto solver = relaxation_stage<Rock>(scene);
  if (scene.stress.horizontal == 0 && scene.stress.vertical == 0) {  // at rest; a relaxation would chase round-off
    summary.relaxation = {0, 0};
    return std::move(solver.body());
  }
  Progress progress("relaxation");
  const std::int64_t particles = static_cast<std::int64_t>(solver.body().size());
  LastGood<decltype(solver)> last_good(scene, folder);
  last_good.keep(solver);
  try {
    const auto report = mpm::relax(
        solver, {.tolerance = scene.relaxation.tolerance, .max_steps = scene.relaxation.max_steps}, [&](const auto& s) {
          progress.update(s.steps, s.time, s.time / double(s.steps), s.steps * particles);
          last_good.keep(s);
        });
    summary.relaxation = {report.unbalanced_force, report.kinetic_ratio};
  } catch (const mpm::Error& error) {
    last_good.leave(solver, error);
  }
  progress.finish();
  summary.steps.relaxation = solver.steps;
  return std::move(solver.body());
}

/// Speed of a longitudinal wave in rock at rest, m/s.
template <class Body>
double wave_speed(const Body& rock) {
  const auto moduli = rock.law.tangent(rock.law.template initial<double>(), 1.0);
  return std::sqrt(moduli.longitudinal / rock.law.density);
}

inline std::string title(const Scene& scene, double time) {
  char text[160];
  const auto& s = scene.stress;
  const int length = std::snprintf(text, sizeof text, "%.0f us, in-situ stress %g MPa horizontal, %g MPa vertical",
                                   time * 1e6, s.horizontal * 1e-6, s.vertical * 1e-6);
  if (s.direction != 0) std::snprintf(text + length, sizeof text - length, ", turned by %g degrees", s.direction);
  return text;
}

/// Window of the pictures: the holes, the cracks and as much again, at least twenty hole radii.
inline double window(const Scene& scene, const Summary& summary) {
  const auto middle = scene.middle();
  double farthest = 0;
  for (std::size_t k = 0; k < scene.holes(); ++k)
    farthest = std::max({farthest, std::abs(scene.hole.x[k] - middle[0]), std::abs(scene.hole.y[k] - middle[1])});
  return std::min(half_side(scene), farthest + std::max(1.25 * summary.crack.longest, 20 * scene.hole.radius));
}

/// When charges are lit, s, the latest first.
inline std::vector<double> lighting_times(const Scene& scene) {
  std::vector<double> times;
  for (std::size_t k = 0; k < scene.holes(); ++k) times.push_back(scene.lighting_time(k));
  std::ranges::sort(times, std::greater<>{});
  return times;
}

template <class Solver>
void finish(Solver& solver, const Scene& scene, const std::filesystem::path& folder, Summary& summary) {
  auto& rock = solver.template body<0>();
  summary.simulated_seconds = solver.time;
  summary.steps.blast = solver.steps;
  summary.crack = measure_cracks(rock, scene);
  write_rose(rock, scene, folder / "rose.csv");
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(mpm::state_hash(solver)));
  summary.state_hash = hash;
  draw_rock(rock, scene, title(scene, solver.time), window(scene, summary), folder);
  draw_chart({.title = "energies per metre of hole", .quantity = "energy", .unit = "MJ/m", .scale = 1e-6},
             folder / "energies.csv", folder / "energies.png");
  draw_chart({.title = "stresses at the wall and the probes", .quantity = "stress", .unit = "MPa", .scale = 1e-6},
             folder / "probes.csv", folder / "probes.png");
}

/// Stage 2, from the relaxed rock to the end time.
template <class Rock, class Integrator>
void blast(const Scene& scene, const std::filesystem::path& folder, typename Rock::Body rock, Summary& summary) {
  auto solver = blast_stage<Rock, Integrator>(scene, std::move(rock));
  summary.particles = {std::int64_t(solver.template body<0>().size()), std::int64_t(solver.template body<1>().size()),
                       std::int64_t(solver.template body<2>().size())};
  const double charge_energy = energy_of(solver.template body<1>(), scene);
  const std::int64_t particles = summary.particles.rock + summary.particles.charge + summary.particles.air;
  Recorder<decltype(solver)> recorder(scene, folder, charge_energy);
  recorder.record(solver);
  Progress progress("blast", scene.end_time);
  // A charge acts at once: a step of full length there would lose 1 % of its energy, a small one that grows does not.
  const double first = 0.05 * scene.grid.cell / wave_speed(solver.template body<0>());
  double longest = first;
  auto lightings = lighting_times(scene);
  LastGood<decltype(solver)> last_good(scene, folder);
  mpm::EnergyGuard guard;
  last_good.keep(solver);
  try {
    for (; solver.time < scene.end_time; longest *= 1.1) {
      for (; !lightings.empty() && lightings.back() <= solver.time; lightings.pop_back()) longest = first;
      const double next = lightings.empty() ? scene.end_time : lightings.back();
      const double due = std::min({scene.end_time, recorder.next_snapshot_time(), next}) - solver.time;
      const double dt = solver.step(std::min(longest, due));
      guard(solver);
      progress.update(solver.steps, solver.time, dt, solver.steps * particles);
      recorder.record(solver);
      last_good.keep(solver);
    }
  } catch (const mpm::Error& error) {
    last_good.leave(solver, error);
  }
  progress.finish();
  summary.wall_radial_stress = recorder.wall_radial_stress();
  summary.energy = energies(solver, scene, charge_energy);
  summary.energy["largest_loss"] = recorder.largest_loss();
  finish(solver, scene, folder, summary);
}

template <class Rock>
void blast_as_asked(const Scene& scene, const std::filesystem::path& folder, typename Rock::Body rock,
                    Summary& summary) {
  switch (scene.step.update) {
    case StressUpdate::usl:
      return blast<Rock, mpm::Usl>(scene, folder, std::move(rock), summary);
    case StressUpdate::usf:
      return blast<Rock, mpm::Usf>(scene, folder, std::move(rock), summary);
    case StressUpdate::musl:
      return blast<Rock, mpm::Musl>(scene, folder, std::move(rock), summary);
  }
}

/// Particles, bytes, steps and time that the run would take; the rate is measured over a few steps of the rock.
template <class Rock>
void dry_run(const Scene& scene) {
  const auto charge = make_charge(scene);
  const auto air = make_air(scene);
  auto solver = relaxation_stage<Rock>(scene);
  solver.safety = scene.step.safety;
  const auto& rock = solver.body();
  solver.step();
  const auto begin = Clock::now();
  double dt = 0;
  for (int k = 0; k < 3; ++k) dt = solver.step();
  const double per_particle = seconds_since(begin) / 3 / double(rock.size());
  const double bytes = double(rock.size()) * double(rock.bytes_per_particle) +
                       double(charge.size()) * double(charge.bytes_per_particle) +
                       double(air.size()) * double(air.bytes_per_particle);
  // Shocked rock at the wall takes about a fifth of the step at rest; a blast step costs about twice a relaxation's.
  const double steps = 5 * scene.end_time / dt, relaxation = scene.stress.start == StressStart::kirsch ? 50 : 1000;
  const double particles = double(rock.size() + charge.size() + air.size());
  std::printf("particles: rock %zu, charge %zu, air %zu\n", rock.size(), charge.size(), air.size());
  std::printf("memory: %.1f MB for particles\n", bytes * 1e-6);
  std::printf("step: %.3g us in rock at rest\n", dt * 1e6);
  std::printf("steps: about %.0f of relaxation and %.0f of blast\n", relaxation, steps);
  std::printf("time: about %.0f s\n", per_particle * (relaxation * double(rock.size()) + 2 * steps * particles));
}

}  // namespace detail

template <class Rock>
void run_with(const Scene& scene, const Options& options) {
  if (options.dry_run) return detail::dry_run<Rock>(scene);
  const detail::Cost cost;
  const auto& folder = options.output;
  Summary summary;
  summary.threads = program::threads_in_use();
  try {
    auto rock = detail::relax_rock<Rock>(scene, folder, summary);
    if (const auto capped = scatter_strength(rock, scene); capped > 0)
      std::fprintf(stderr,
                   "warning: the tensile strength of %zu of %zu rock particles is capped at %.1f MPa, where they would "
                   "snap back; refine rock.particle or raise rock.tensile.fracture_energy\n",
                   capped, rock.size(), largest_tensile_strength(scene) * 1e-6);
    detail::blast_as_asked<Rock>(scene, folder, std::move(rock), summary);
  } catch (const std::exception&) {
    cost.write(summary);
    write_summary(folder / "summary.json", summary);  // says that the run is not complete
    throw;
  }
  summary.completed = true;
  cost.write(summary);
  write_summary(folder / "summary.json", summary);
  std::printf(
      "reach %.0f mm (along x %.0f, along y %.0f), damaged area %.0f cm2, crushed radius %.0f mm, %.0f s; results in "
      "%s\n",
      summary.crack.reach * 1e3, summary.crack.along_x * 1e3, summary.crack.along_y * 1e3, summary.crack.area * 1e4,
      summary.crack.crushed_radius * 1e3, summary.wall_seconds, folder.c_str());
}

}  // namespace blasting
