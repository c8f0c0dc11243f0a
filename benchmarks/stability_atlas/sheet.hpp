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
    std::string method;  ///< "Cpdi USL"
    double x = 0, y = 0;
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
  std::map<std::string, std::string> refused{};  ///< methods that do not compile for it: the compiler's reason
  std::vector<Point> points{};
};

/// "stands (0.17 %)", with the largest value, or "falls at A = 0.05 (56 %)", with the first beyond the limit.
std::string verdict(const Sheet& sheet, const std::string& method);

/// The methods of the sheets in the order of their first appearance.
std::vector<std::string> methods_of(const std::vector<Sheet>& sheets);

/// A row a mode as a Markdown table: which methods stand, with their largest value, and where the others fall.
std::string markdown(const std::vector<Sheet>& sheets);

/// All points as CSV.
void write(const std::vector<Sheet>& sheets, const std::filesystem::path& file);

/// A line a method, and the limit. False if gnuplot is missing.
bool draw(const Sheet& sheet, const std::filesystem::path& png);

}  // namespace mpm::atlas
