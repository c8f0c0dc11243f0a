// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace accuracy_cost {

/// What the command line asks for; the member initialisers are what holds without an option.
struct Options {
  enum class Command { help, chart, tune } command = Command::help;
  std::vector<std::string> problems;      ///< empty: all of them
  bool quick = false;                     ///< chart: the sizes of a quick chart
  bool force = false;                     ///< chart: write over an earlier one
  bool check = false;                     ///< tune: on variants held out of the table
  double error = 0;                       ///< tune: the budget, relative
  std::filesystem::path output{"chart"};  ///< chart: folder of the results; tune: of the chart it reads
};

/// Reads the command line. Throws mpm::io::InputError: unknown command, option or problem, missing or bad value.
Options parse(int argc, const char* const* argv);

/// "1%", "1 %" or "0.01" as 0.01. Throws mpm::io::InputError unless it is above 0 and below 100 %.
double parse_share(const std::string& text);

void print_help(std::ostream& out);

}  // namespace accuracy_cost
