// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mpm::atlas {

/// One way to fail: a curve a method, and the value beyond which it has fallen.
struct Sheet {
  struct Point {
    std::string shape;       ///< "Cpdi"
    std::string integrator;  ///< "USL"; none where the shape alone tells
    double x = 0;
    double y = 0;  ///< infinite where the run stops, no number where its steps become too short
  };
  std::string name{};     ///< of its files: "amplitude"
  std::string mode{};     ///< in the table: "growing amplitude"
  std::string title{};    ///< of the picture
  std::string x_label{};  ///< with its unit
  std::string y_label{};
  std::string at{};             ///< what x is where a method falls: "A = "
  double limit = 0;             ///< fallen if y is larger, or no number
  double judged_from = -1e300;  ///< x from which the limit holds
  double percent = 1;           ///< factor of y for the table: 100 and a % sign, or 1
  bool log_x = false, log_y = true;
  std::map<std::string, std::string> refused{};  ///< shapes that do not compile for it: the compiler's reason
  std::vector<Point> points{};
};

/// "0.17 %", the largest value of a method that stands, or "**A = 0.05** (56 %)", the first beyond the limit; empty for
/// methods that the sheet has not.
std::string verdict(const Sheet& sheet, const std::string& shape, const std::string& integrator);

/// A row a method and a column a mode as a Markdown table: where the method falls, or how well it stands.
std::string markdown(const std::vector<Sheet>& sheets);

/// All points as CSV.
void write(const std::vector<Sheet>& sheets, const std::filesystem::path& file);

/// A line a method, in a panel a shape where shapes have several, and the limit. False if gnuplot is missing.
bool draw(const Sheet& sheet, const std::filesystem::path& png);

}  // namespace mpm::atlas
