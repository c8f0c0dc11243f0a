// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mpm/io/units.hpp>
#include <paper/options.hpp>
#include <paper/page.hpp>
#include <paper/states.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>

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
        s[{50, 50}].tension = s[{0, 0}].tension;
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

TEST(Options, AreReadOrRefused) {
  const char* good[] = {"paper", "--quick", "--output", "somewhere", "--threads", "3"};
  const auto options = parse(std::size(good), good);
  EXPECT_TRUE(options.quick);
  EXPECT_EQ(options.output, "somewhere");
  EXPECT_EQ(options.threads, 3);
  for (const char* bad : {"--fast", "stray", "--threads=0", "--threads=two", "--output="}) {
    const char* args[] = {"paper", bad};
    EXPECT_THROW(parse(std::size(args), args), mpm::io::InputError) << bad;
  }
}

TEST(Options, FolderIsThisReportsOwn) {
  const fs::path folder = fs::path(::testing::TempDir()) / "paper_folder";
  fs::remove_all(folder);
  Options options{.output = folder, .quick = true};
  prepare_folder(options);
  prepare_folder(options);  // goes on with it
  options.quick = false;
  EXPECT_THROW(prepare_folder(options), mpm::io::InputError);  // another size
  fs::remove_all(folder);
  fs::create_directories(folder / "of somebody else");
  EXPECT_THROW(prepare_folder(options), mpm::io::InputError);
}

TEST(Page, IsWholeAndItsTableMarkdown) {
  const fs::path folder = fs::path(::testing::TempDir()) / "paper_page";
  fs::create_directories(folder);
  const TableOf table{{"Claim", "Holds"}, {{"k &lt; 1", "<span class=\"no\">no</span>"}}};
  EXPECT_EQ(table.markdown(), "| Claim | Holds |\n|---|---|\n| k < 1 | **no** |\n");
  Page page;
  page.section("Claims", "claims");
  page.table(table);
  page.figure(folder, "missing.png", "Without gnuplot there is no picture.");
  page.write(folder, "Title", "<p>head</p>");
  std::ifstream file(folder / "index.html");
  const std::string html{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(html.find("<td><span class=\"no\">no</span></td>"), std::string::npos);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_NE(html.find("</html>"), std::string::npos);
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

// Three sets of coarse runs, judged as the report judges: a claim must hold for two seeds of three, as one particle
// that breaks alone can upset an extent, and another compiler breaks another one. But cracks at 50 MPa creep on these
// cells: there the bar is 5 %, and a quarter of what they grow without stress.
TEST(Claims, HoldOnCoarseCells) {
  const fs::path folder = fs::path(::testing::TempDir()) / "paper_claims";
  fs::remove_all(folder);
  std::map<std::string, int> held;
  std::map<std::string, std::string> measured;
  const auto take = [&](const std::string& claim, bool holds, const std::string& found) {
    held[claim] += holds, measured[claim] += "\n" + found;
  };
  for (const int seed : {1, 2, 3}) {
    States states;
    for (const auto& state : all_states()) {
      const auto blast = run({name_of(state) + "-seed" + std::to_string(seed), coarse_quarter(state, seed)}, folder);
      ASSERT_TRUE(blast.completed()) << blast.problem;
      states[state] = measure(blast);
      EXPECT_LE(blast.number("energy.largest_loss"), .01 * blast.number("energy.charge")) << name_of(state);
    }
    const double creep = states.at({50, 50}).late_growth, growth = states.at({0, 0}).late_growth;
    take("cracks at 50 MPa creep", creep < .05 && creep < growth / 4, std::to_string(creep));
    states.at({50, 50}).late_growth = 0;
    for (const auto& finding : judge(states)) take(finding.claim, finding.holds, finding.measured);
  }
  for (const auto& [claim, count] : held) EXPECT_GE(count, 2) << claim << ':' << measured.at(claim);
}

}  // namespace
