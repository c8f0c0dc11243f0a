// SPDX-License-Identifier: MIT
#pragma once
#include "recorder.hpp"
#include <mpm/error.hpp>
#include <mpm/io/text.hpp>
#include <chrono>

namespace blasting {

/// A copy of the particles that is a little old, for when a run has to stop: the step that fails has already changed
/// them.
template <class Solver>
class LastGood {
 public:
  LastGood(const Scene& scene, const std::filesystem::path& folder) : scene_(scene), stem_(folder / "last_good") {}

  /// Copies them whenever the last copy took less than a hundredth of the time since. (A step costs less than a copy
  /// while most of the rock rests, so that no number of steps between two would do.)
  void keep(const Solver& solver) {
    const auto begin = Clock::now();
    if (begin - kept_ < 100 * cost_) return;
    bodies_ = solver.bodies, time_ = solver.time, steps_ = solver.steps;
    kept_ = Clock::now(), cost_ = kept_ - begin;
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
  using Clock = std::chrono::steady_clock;
  const Scene& scene_;
  std::filesystem::path stem_;
  typename Solver::BodyList bodies_{};
  double time_ = 0;
  std::int64_t steps_ = 0;
  Clock::time_point kept_{};  ///< end of the last copy
  Clock::duration cost_{};    ///< of it
};

}  // namespace blasting
