// SPDX-License-Identifier: MIT
#include "progress.hpp"
#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <utility>

namespace blasting {
namespace {

using namespace std::chrono_literals;

/// `value` with the SI prefix that leaves one to three digits before the point: 8.21e-8 s is "82.1 ns".
std::string with_prefix(double value, const char* unit) {
  constexpr const char* prefixes[] = {"n", "u", "m", "", "k", "M", "G"};
  int thousands = value > 0 ? static_cast<int>(std::floor(std::log10(value * 1.0005) / 3)) : 0;  // 999.7 prints as 1000
  thousands = std::clamp(thousands, -3, 3);
  char text[48];
  std::snprintf(text, sizeof text, "%.3g %s%s", value / std::pow(1000.0, thousands), prefixes[thousands + 3], unit);
  return text;
}

/// Seconds as h:mm:ss or m:ss.
std::string clock_time(double seconds) {
  const long long s = std::llround(std::min(seconds, 3.6e7));
  char text[32];
  if (s >= 3600)
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", s / 3600, s / 60 % 60, s % 60);
  else
    std::snprintf(text, sizeof text, "%lld:%02lld", s / 60, s % 60);
  return text;
}

/// Columns of the terminal; a longer line would wrap and could not be rewritten.
std::size_t columns(std::FILE* out) {
  winsize size{};
  return ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col - 1U : 79U;
}

}  // namespace

Progress::Progress(std::string stage, double end_time, std::FILE* out)
    : stage_(std::move(stage)), end_time_(end_time), out_(out), terminal_(isatty(fileno(out))) {}

Progress::~Progress() {
  if (line_open_) std::fputc('\n', out_);
}

void Progress::update(std::int64_t step, double time, double dt, std::int64_t particle_steps) {
  step_ = step, time_ = time, dt_ = dt, particle_steps_ = particle_steps;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + (terminal_ ? Clock::duration(200ms) : Clock::duration(10s));
  const double elapsed = seconds();
  const bool ends = std::isfinite(end_time_) && time_ > 0;
  print(line(elapsed, ends ? clock_time(elapsed * std::max(0.0, end_time_ / time_ - 1)) + " left, " : ""), false);
}

void Progress::finish() {
  const double elapsed = seconds();
  print(line(elapsed, "") + ", " + std::to_string(step_) + " steps in " + clock_time(elapsed), true);
}

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - begin_).count();
}

std::string Progress::line(double elapsed, const std::string& left) const {
  std::string text = stage_ + ": " + with_prefix(time_, "s");
  if (std::isfinite(end_time_)) {
    char share[16];
    std::snprintf(share, sizeof share, " (%.0f %%)", 100 * time_ / end_time_);
    text += " of " + with_prefix(end_time_, "s") + share;
  }
  const double rate = elapsed > 0 ? static_cast<double>(particle_steps_) / elapsed : 0;
  return text + ", " + left + "step " + with_prefix(dt_, "s") + ", " + with_prefix(rate, "particle-steps/s");
}

void Progress::print(const std::string& text, bool last) {
  if (terminal_)
    std::fprintf(out_, "\r%s\x1b[K%s", text.substr(0, columns(out_)).c_str(), last ? "\n" : "");
  else
    std::fprintf(out_, "%s\n", text.c_str());
  std::fflush(out_);
  line_open_ = terminal_ && !last;
}

}  // namespace blasting
