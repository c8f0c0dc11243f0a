// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <blasting/run.hpp>
#include <paper/states.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <sstream>

// What the report of ./run.sh paper says of the twelve blasts of Xiao et al. 2024: that it can say no, and that on
// coarse cells the answer is what the README states.
namespace {

namespace fs = std::filesystem;
using namespace paper;

/// Numbers of which every claim is true.
States as_claimed() {
  States states;
  const auto put = [&](State state, double reach, double x, double y) {
    states[state] = {.reach = reach,
                     .along_x = x,
                     .along_y = y,
                     .area = reach,
                     .crushed = .04,
                     .late_growth = 0,
                     .longest = x > y ? 5. : 85.,
                     .compression = -60e6,
                     .tension = 30e6 * reach,
                     .hole = .021,
                     .half_side = 1.5};
  };
  for (const double level : equiaxial_levels) put({level, level}, 1 - level / 100, 1 - level / 100, 1 - level / 100);
  states[{50, 50}].compression = -90e6;
  put({10, 40}, .9, .5, .9), put({20, 40}, .8, .5, .8), put({60, 40}, .6, .55, .5), put({80, 40}, .6, .55, .4);
  put({120, 40}, .6, .6, .3);
  return states;
}

std::vector<bool> verdicts(const States& states) {
  std::vector<bool> holds;
  for (const auto& finding : judge(states)) holds.push_back(finding.holds);
  return holds;
}

TEST(Claims, EachCanFail) {
  const auto holds = verdicts(as_claimed());
  ASSERT_EQ(holds.size(), 13u);
  for (std::size_t i = 0; i < holds.size(); ++i) EXPECT_TRUE(holds[i]) << judge(as_claimed())[i].claim;
  const std::function<void(States&)> breaks[] = {
      [](States& s) {
        s[{30, 30}].reach = s[{20, 20}].reach;
      },
      [](States& s) {
        s[{50, 50}].area = .3 * s[{0, 0}].area;
      },
      [](States& s) {
        s[{50, 50}].late_growth = .03;
      },
      [](States& s) {
        s[{10, 10}].along_y *= 1.21;
      },
      [](States& s) {
        s[{50, 50}].compression = -50e6;
      },
      [](States& s) {
        s[{40, 40}].tension = s[{30, 30}].tension;
      },
      [](States& s) {
        s[{10, 40}].along_x = .8;
      },
      [](States& s) {
        s[{80, 40}].along_x = .39;
      },
      [](States& s) {
        s[{20, 40}].longest = 59;
      },
      [](States& s) {
        s[{80, 40}].along_y = s[{60, 40}].along_y;
      },
      [](States& s) {
        s[{120, 40}].along_x = .8;
      },
      [](States& s) {
        s[{80, 40}].along_y = .46;
      },
      [](States& s) {
        s[{0, 0}].crushed = .02;
      },
  };
  for (std::size_t i = 0; i < std::size(breaks); ++i) {
    auto states = as_claimed();
    breaks[i](states);
    EXPECT_FALSE(verdicts(states)[i]) << judge(states)[i].claim;
  }
}

// Completed runs are read, those cut short and other scenes are run, those that failed are told.
TEST(Runs, AreNotRunAgain) {
  const fs::path folder = fs::path(::testing::TempDir()) / "paper_runs";
  fs::remove_all(folder);
  Case one{"one", coarse_quarter({20, 20}, 1)};
  one.scene.block.side = .6, one.scene.output.probes = {.1}, one.scene.end_time = 10e-6;
  const auto first = run(one, folder);
  EXPECT_TRUE(first.completed());
  const auto written = fs::last_write_time(first.folder / "summary.json");
  EXPECT_EQ(run(one, folder).number("crack.reach"), first.number("crack.reach"));
  EXPECT_EQ(fs::last_write_time(first.folder / "summary.json"), written);
  fs::remove(first.folder / "summary.json");  // cut short
  EXPECT_TRUE(run(one, folder).completed());
  one.scene.seed = 2;  // another scene
  EXPECT_NE(run(one, folder).summary.get<std::string>("state_hash"), first.summary.get<std::string>("state_hash"));
  // A scene that cannot be run leaves its reason, and is not tried again.
  one.scene.relaxation.max_steps = 1;
  EXPECT_NE(run(one, folder).problem.find("not at rest"), std::string::npos);
  EXPECT_NE(run(one, folder).problem.find("not at rest"), std::string::npos);
  EXPECT_TRUE(std::isnan(run(one, folder).number("crack.reach")));
}

/// One set of coarse runs, judged as the report judges.
TEST(Claims, HoldOnCoarseCells) {
  const fs::path folder = fs::path(::testing::TempDir()) / "paper_claims";
  fs::remove_all(folder);
  States states;
  for (const auto& state : all_states()) {
    auto scene = coarse_quarter(state, 1);
    scene.block.side = 2.4;
    const auto blast = run({name_of(state), scene}, folder);
    ASSERT_TRUE(blast.completed()) << blast.problem;
    states[state] = measure(blast);
    EXPECT_LE(blast.number("energy.largest_loss"), .01 * blast.number("energy.charge")) << name_of(state);
  }
  for (const auto& finding : judge(states)) EXPECT_TRUE(finding.holds) << finding.claim << ": " << finding.measured;
}

}  // namespace
