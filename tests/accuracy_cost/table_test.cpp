// SPDX-License-Identifier: MIT
#include <accuracy_cost/picture.hpp>
#include <accuracy_cost/table.hpp>
#include <mpm/io/units.hpp>
#include <snapshot/temporary_folder.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include "rows.hpp"

namespace accuracy_cost {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Front, HoldsWhatNothingBeats) {
  const Table table{row("Ugimp", 8, .1, 1),   row("Cpdi", 8, .05, 2),      row("Linear", 8, .1, 3),
                    row("Ugimp", 16, .05, 8), row("Linear", 16, nan, nan), row("Cpdi", 16, .01, 20)};
  const Table best = front(table);
  ASSERT_EQ(best.size(), 3u);
  EXPECT_EQ(best[0].method.shape, "Ugimp");
  EXPECT_EQ(best[1].method.shape, "Cpdi");
  EXPECT_EQ(best[2].error, .01);
}

TEST(Table, CostsAreRelatedToLinearShapesOfTheSameSize) {
  Table table{row("Linear", 8, .1, 2), row("Cpdi", 8, .05, 3), row("Cpdi", 16, .01, 24)};
  table[0].relative_cost = table[1].relative_cost = nan;
  relate_costs(table);
  EXPECT_EQ(table[0].relative_cost, 1);
  EXPECT_EQ(table[1].relative_cost, 1.5);
  EXPECT_TRUE(std::isnan(table[2].relative_cost));
}

TEST(Table, ReadsBackToTheBit) {
  const TemporaryFolder folder;
  Row odd = row("CpdiQuad", 48, 1 / 3., 1e-5);
  odd.method.transfer = "full-mass FLIP(4)", odd.method.cfl = .25, odd.method.scene = "full plane",
  odd.relative_cost = nan;
  const Table written{odd, row("Linear", 8, nan, nan)};
  write(written, folder / "chart.csv");
  const Table back = read(folder / "chart.csv");
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].problem, "test");
  EXPECT_EQ(back[0].method, odd.method);
  EXPECT_EQ(back[0].cells, 48);
  EXPECT_EQ(back[0].error, 1 / 3.);
  EXPECT_EQ(back[0].cost, 1e-5);
  EXPECT_EQ(back[0].particles, 96);
  EXPECT_EQ(back[0].steps, 480);
  EXPECT_EQ(back[0].bytes, 56u);
  EXPECT_TRUE(std::isnan(back[0].relative_cost) && std::isnan(back[1].error));
}

std::string refusal(const std::filesystem::path& file) {
  try {
    read(file);
  } catch (const mpm::io::InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Table, WhatIsNoChartIsRefusedByLine) {
  const TemporaryFolder folder;
  write({row("Linear", 8, .1, 1)}, folder / "chart.csv");
  std::ofstream(folder / "chart.csv", std::ios::app) << "half a row,Cpdi\n";
  EXPECT_NE(refusal(folder / "chart.csv").find("chart.csv:3"), std::string::npos);
  write({row("eight", 8, .1, 1)}, folder / "chart.csv");
  std::string text = content(folder / "chart.csv");
  std::ofstream(folder / "chart.csv") << text.replace(text.rfind(",8,"), 3, ",x,");
  EXPECT_NE(refusal(folder / "chart.csv").find("chart.csv:2"), std::string::npos);
  EXPECT_NE(refusal(folder / "nothing.csv"), "none");
}

TEST(Picture, IsDrawn) {
  const TemporaryFolder folder;
  const Table table{row("Ugimp", 8, .1, 1), row("Ugimp", 16, .03, 8), row("Linear", 8, nan, nan)};
  ASSERT_TRUE(draw(table, "it's", folder / "test.png")) << "gnuplot is not there";
  EXPECT_EQ(content(folder / "test.png").substr(1, 3), "PNG");
  Table scenes{row("Ugimp", 8, .1, 1), row("Ugimp", 8, .1, 4)};
  scenes[0].method.scene = "quarter plane", scenes[1].method.scene = "full plane";
  EXPECT_TRUE(draw(scenes, "scenes", folder / "scenes.png"));
}

}  // namespace
}  // namespace accuracy_cost
