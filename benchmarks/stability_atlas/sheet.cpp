// SPDX-License-Identifier: MIT
#include "sheet.hpp"
#include <mpm/io/csv.hpp>
#include <mpm/io/text.hpp>
#include <program/gnuplot.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mpm::atlas {
namespace {

std::string rounded(double value, const char* format = "%.2g") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}
std::string value_of(const Sheet& sheet, double y) {
  if (!std::isfinite(y)) return "the run stops";
  return sheet.percent == 1 ? rounded(y) : rounded(sheet.percent * y) + " %";
}
void add_once(std::vector<std::string>& list, const std::string& word) {
  if (std::ranges::find(list, word) == list.end()) list.push_back(word);
}

}  // namespace

std::string verdict(const Sheet& sheet, const std::string& method) {
  if (const auto r = sheet.refused.find(method); r != sheet.refused.end()) return r->second;
  bool tried = false;
  double largest = 0;
  for (const Sheet::Point& p : sheet.points) {
    if (p.method != method || p.x < sheet.judged_from) continue;
    tried = true;
    if (!(p.y <= sheet.limit)) return "falls at " + sheet.at + rounded(p.x, "%.3g") + " (" + value_of(sheet, p.y) + ")";
    largest = std::max(largest, p.y);
  }
  return tried ? "stands (" + value_of(sheet, largest) + ")" : "-";
}

std::vector<std::string> methods_of(const std::vector<Sheet>& sheets) {
  std::vector<std::string> methods;
  for (const Sheet& sheet : sheets) {
    for (const auto& p : sheet.points) add_once(methods, p.method);
    for (const auto& [method, reason] : sheet.refused) add_once(methods, method);
  }
  return methods;
}

std::string markdown(const std::vector<Sheet>& sheets) {
  std::string text = "| mode | stands | falls |\n|---|---|---|\n";
  for (const Sheet& sheet : sheets) {
    std::string stands, falls;
    for (const std::string& method : methods_of({sheet})) {
      const std::string said = verdict(sheet, method), stand = "stands ", fall = "falls at ";
      std::string& list = said.starts_with(stand) ? stands : falls;
      list += (list.empty() ? "" : "; ") + method + ' ';
      list += said.starts_with(stand)  ? said.substr(stand.size())
              : said.starts_with(fall) ? "at " + said.substr(fall.size())
                                       : '(' + said + ')';
    }
    text += "| " + sheet.mode + " | " + stands + " | " + falls + " |\n";
  }
  return text;
}

void write(const std::vector<Sheet>& sheets, const std::filesystem::path& file) {
  mpm::io::CsvWriter out(file, {{"sheet", "1"}, {"method", "1"}, {"x", "1"}, {"y", "1"}});
  for (const Sheet& sheet : sheets)
    for (const auto& p : sheet.points)
      out.row(std::vector<std::string>{sheet.name, p.method, mpm::io::number(p.x), mpm::io::number(p.y)});
}

bool draw(const Sheet& sheet, const std::filesystem::path& png) {
  // Okabe and Ito's colours, which the colour-blind can tell apart, without their yellow.
  static const std::vector<std::string> colours{"#000000", "#E69F00", "#56B4E9", "#009E73",
                                                "#CC79A7", "#0072B2", "#D55E00"};
  const program::Gnuplot gnuplot(png);
  std::string data, plot;
  std::size_t index = 0;
  double left = 1e300, right = -1e300;
  for (const auto& p : sheet.points) left = std::min(left, p.x), right = std::max(right, p.x);
  for (const std::string& method : methods_of({sheet})) {
    std::string line;
    for (const auto& p : sheet.points)
      if (p.method == method && std::isfinite(p.y) && (p.y > 0 || !sheet.log_y))
        line += mpm::io::number(p.x) + ' ' + mpm::io::number(sheet.percent * p.y) + '\n';
    if (line.empty()) continue;
    data += line + "\n\n";
    const std::size_t k = index++;
    plot += (k ? ", " : "plot ") + ("'lines' index " + std::to_string(k)) +
            " with linespoints linewidth 2 pointsize 0.8 pointtype " + std::to_string(4 + k % 10) + " dashtype " +
            std::to_string(1 + k / colours.size()) + " linecolor rgb '" + colours[k % colours.size()] + "' title " +
            program::gnuplot_string(method);
  }
  if (index == 0) return true;
  mpm::io::replace_file(gnuplot.folder() / "lines", data);
  const std::string limit = mpm::io::number(sheet.percent * sheet.limit);
  std::string axes;
  if (sheet.log_x) axes += "set logscale x\n";
  if (sheet.log_y) axes += "set logscale y\n";
  return gnuplot.draw(1000, 560,
                      "set label 1 font ',14' " + program::gnuplot_string(sheet.title) +
                          " at screen 0.5,0.96 center\nset tmargin 3\nset grid\nset format '%g'\n" + axes +
                          "set xlabel " + program::gnuplot_string(sheet.x_label) + "\nset ylabel " +
                          program::gnuplot_string(sheet.y_label) +
                          "\nset key outside right top vertical maxcols 1 samplen 1.5 spacing 1.0 font ',13'\nset "
                          "arrow 1 from graph 0, first " +
                          limit + " to graph 1, first " + limit +
                          " nohead dashtype 2 linewidth 2 linecolor rgb '#777777'\n" + plot + '\n');
}

}  // namespace mpm::atlas
