// SPDX-License-Identifier: MIT
#include <blasting/summary.hpp>
#include <gtest/gtest.h>
#include <clocale>
#include "run_python.hpp"
#include "temporary_folder.hpp"

namespace {

blasting::Summary example() {
  return {.completed = true,
          .simulated_seconds = 1 / 3e4,
          .wall_seconds = 301.5,
          .cpu_seconds = 512.25,
          .steps = {.relaxation = 4000, .blast = 12345678901},
          .particles = {.rock = 40000, .charge = 2000, .air = 700},
          .relaxation = {.unbalanced_force = 1e-10, .kinetic_ratio = 2.5e-12},
          .crack = {.reach = 0.658,
                    .along_x = 0.391,
                    .longest = 0.7,
                    .area = 0.2721,
                    .crushed_area = 0.0117,
                    .crushed_radius = 0.0625},
          .wall_radial_stress = -1.5e6,
          .energy = {{"charge", 5e6}, {"dissipated \"crack\"", 0.1}},
          .threads = 3,
          .state_hash = "0123456789abcdef"};
}

TEST(Summary, IsJsonWithNumbersAsNumbers) {
  const TemporaryFolder folder;
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed, a comma is the decimal point of printf
  blasting::write_summary(folder / "summary.json", example());
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(run_python("read_summary.py", folder / "summary.json"), 0) << content(folder / "summary.json");
}

TEST(Summary, FailedWriteKeepsTheOldOne) {
  const TemporaryFolder folder;
  blasting::write_summary(folder / "summary.json", {});
  const std::string old = content(folder / "summary.json");
  EXPECT_NE(old.find("\"reach\": null"), std::string::npos) << old;
  std::filesystem::create_directory(folder / "summary.json.part");
  EXPECT_THROW(blasting::write_summary(folder / "summary.json", example()), std::runtime_error);
  EXPECT_EQ(content(folder / "summary.json"), old);
  EXPECT_THROW(blasting::write_summary(folder / "nowhere/summary.json", {}), std::runtime_error);
}

}  // namespace
