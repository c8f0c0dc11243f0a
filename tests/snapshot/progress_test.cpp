// SPDX-License-Identifier: MIT
#include <blasting/progress.hpp>
#include <gtest/gtest.h>
#include <algorithm>
#include <pty.h>
#include <unistd.h>
#include <chrono>
#include <string>
#include <thread>
#include "temporary_folder.hpp"

namespace {

using blasting::Progress;

/// What a stage of a thousand quick steps to 300 us prints.
void run_stage(std::FILE* out) {
  Progress progress("blast", 300e-6, out);
  for (int step = 1; step <= 1000; ++step) progress.update(step, step * 300e-9, 82.1e-9, step * 50000LL);
  progress.finish();
}

/// Runs `print` on a terminal of the given width and returns what arrives there.
template <class Print>
std::string on_terminal(unsigned short width, Print print) {
  int master = 0, slave = 0;
  const winsize size{24, width, 0, 0};
  if (openpty(&master, &slave, nullptr, nullptr, &size) != 0) return "no terminal";
  std::FILE* out = fdopen(slave, "w");
  print(out);
  std::fclose(out);
  std::string text;
  char part[4096];
  for (ssize_t length; (length = read(master, part, sizeof part)) > 0;)
    text.append(part, static_cast<std::size_t>(length));
  close(master);
  return text;
}

TEST(Progress, PlainLinesAreFew) {
  const TemporaryFolder folder;
  std::FILE* out = std::fopen((folder / "log").c_str(), "w");
  run_stage(out);
  std::fclose(out);
  const std::string log = content(folder / "log");
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 2) << log;
  EXPECT_EQ(log.find_first_of("\r\x1b"), std::string::npos) << log;
  EXPECT_EQ(log.rfind("blast: 300 ns of 300 us (0 %), ", 0), 0U) << log;
  EXPECT_NE(log.find(" left, step 82.1 ns, "), std::string::npos) << log;
  EXPECT_NE(log.find("\nblast: 300 us of 300 us (100 %), step 82.1 ns, "), std::string::npos) << log;
  EXPECT_TRUE(log.ends_with("particle-steps/s, 1000 steps in 0:00\n")) << log;
}

TEST(Progress, TerminalLineIsRewrittenInPlaceAndFits) {
  const std::string text = on_terminal(40, run_stage);
  EXPECT_EQ(text.rfind("\rblast: 300 ns of 300 us (0 %), ", 0), 0U) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  const std::string first = text.substr(1, text.find('\r', 1) - 1);
  EXPECT_EQ(first.size(), 39 + std::string("\x1b[K").size()) << first;
}

TEST(Progress, TimeLeftAndRateFollowTheClock) {
  const auto half = [](std::FILE* out) {
    Progress progress("blast", 2.0, out);
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
    progress.update(10, 1.0, 0.1, 1'200'000'000);
  };
  const std::string text = on_terminal(200, half);
  const auto words = text.find("(50 %), 0:01 left, step 100 ms, ");
  ASSERT_NE(words, std::string::npos) << text;
  const double rate = std::stod(text.substr(words + 32));
  EXPECT_TRUE(rate <= 1 || rate > 850) << text;  // 1 G or a little less in a second
}

TEST(Progress, FailureLeavesTheLineBehind) {
  const auto abandon = [](std::FILE* out) {
    Progress progress("relaxation", std::numeric_limits<double>::infinity(), out);
    progress.update(1, 0.9997e-3, 1e-6, 1);
  };
  const std::string text = on_terminal(200, abandon);
  EXPECT_EQ(text.rfind("\rrelaxation: 1 ms, step 1 us, ", 0), 0U) << text;
  EXPECT_TRUE(text.ends_with("\x1b[K\r\n")) << text;
}

}  // namespace
