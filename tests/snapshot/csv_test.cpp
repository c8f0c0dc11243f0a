// SPDX-License-Identifier: MIT
#include <mpm/io/csv.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <string>
#include <vector>
#include "temporary_folder.hpp"

namespace {

using mpm::io::CsvWriter;

TEST(Csv, RowsStandWholeInTheFileAtOnce) {
  const TemporaryFolder folder;
  CsvWriter table(folder / "energies.csv", {{"time", "s"}, {"kinetic", "J/m"}, {"damage", "1"}});
  EXPECT_EQ(content(folder / "energies.csv"), "time [s],kinetic [J/m],damage [1]\n");
  table.row(std::vector{1e-6, -2.5, 1 / 3.0});
  EXPECT_EQ(content(folder / "energies.csv"), "time [s],kinetic [J/m],damage [1]\n1e-06,-2.5,0.3333333333333333\n");
  table.row(std::vector{-std::nan(""), std::numeric_limits<double>::infinity(), 0.0});
  EXPECT_TRUE(content(folder / "energies.csv").ends_with("\nnan,inf,0\n"));
}

TEST(Csv, RowsMayHoldText) {
  const TemporaryFolder folder;
  CsvWriter table(folder / "chart.csv", {{"shape", "1"}, {"error", "1"}});
  table.row(std::vector<std::string>{"Linear", mpm::io::number(.5)});
  EXPECT_EQ(content(folder / "chart.csv"), "shape [1],error [1]\nLinear,0.5\n");
  EXPECT_THROW(table.row(std::vector<std::string>{"a,b", "1"}), std::invalid_argument);
}

TEST(Csv, RefusesWhatItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THROW(CsvWriter(folder / "nowhere/e.csv", {{"time", "s"}}), std::runtime_error);
  EXPECT_THROW(CsvWriter("/dev/full", {{"time", "s"}}), std::runtime_error);
  EXPECT_THROW(CsvWriter(folder / "e.csv", {}), std::invalid_argument);
  EXPECT_THROW(CsvWriter(folder / "e.csv", {{"a,b", "s"}}), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  CsvWriter table(folder / "e.csv", {{"time", "s"}});
  EXPECT_THROW(table.row(std::vector{1.0, 2.0}), std::invalid_argument);
  EXPECT_EQ(content(folder / "e.csv"), "time [s]\n");
}

}  // namespace
