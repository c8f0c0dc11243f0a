// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

namespace blasting {

/// How far one stage of a run is. On a terminal: one line, rewritten in place a few times a second. Elsewhere: a plain
/// line at the stage's beginning, every ten seconds, and at its end.
class Progress {
 public:
  /// A stage that runs from time 0 to `end_time`, s; without one (a relaxation ends when it is at rest) no share and no
  /// time left are shown. Prints to `out`.
  explicit Progress(std::string stage, double end_time = std::numeric_limits<double>::infinity(),
                    std::FILE* out = stderr);
  /// Leaves a terminal's line behind, so that a message of failure stands on its own.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// After a step: its number, the time reached and its size, s, and the particles moved so far, summed over the steps.
  /// Cheap enough to be called after each.
  void update(std::int64_t step, double time, double dt, std::int64_t particle_steps);

  /// Prints the stage's last line, with the steps and the time that it took.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  double seconds() const;
  std::string line(double elapsed, const std::string& left) const;
  void print(const std::string& text, bool last);

  std::string stage_;
  double end_time_;
  std::FILE* out_;
  bool terminal_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_ = begin_;
  bool line_open_ = false;
  std::int64_t step_ = 0, particle_steps_ = 0;
  double time_ = 0, dt_ = 0;
};

}  // namespace blasting
