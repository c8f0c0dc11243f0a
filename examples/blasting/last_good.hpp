// SPDX-License-Identifier: MIT
#pragma once
#include "recorder.hpp"
#include <mpm/error.hpp>
#include <mpm/io/text.hpp>

namespace blasting {

/// A copy of the particles that is a few steps old, for when a run has to stop: the step that fails has already changed
/// them.
template <class Solver>
class LastGood {
 public:
  LastGood(const Scene& scene, const std::filesystem::path& folder) : scene_(scene), stem_(folder / "last_good") {}

  /// Copies them every 50 steps: 50 times less often than a step touches them.
  void keep(const Solver& solver) {
    if (solver.steps % 50 != 0) return;
    bodies_ = solver.bodies, time_ = solver.time, steps_ = solver.steps;
  }
  /// Writes them for ParaView and throws the error on, with where they are.
  [[noreturn]] void leave(Solver& solver, const mpm::Error& error) {
    solver.bodies = bodies_;
    mpm::io::SnapshotSeries(stem_).write(time_, snapshot_of(solver, scene_));
    throw mpm::Error(std::string(error.what()) + "; the last good state, step " + std::to_string(steps_) + " at " +
                     mpm::io::number(time_) + " s, is in " + stem_.string() +
                     ".hdf.series, and scene.info beside it repeats the run");
  }

 private:
  const Scene& scene_;
  std::filesystem::path stem_;
  typename Solver::BodyList bodies_{};
  double time_ = 0;
  std::int64_t steps_ = 0;
};

}  // namespace blasting
