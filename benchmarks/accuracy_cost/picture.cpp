// SPDX-License-Identifier: MIT
#include "picture.hpp"
#include <mpm/io/text.hpp>
#include <program/gnuplot.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace accuracy_cost {
namespace {

using mpm::io::number;
using program::gnuplot_string;

/// Numbers what is told apart by one mark, in the order of appearance.
class Key {
 public:
  std::size_t operator[](const std::string& word) {
    const auto found = std::ranges::find(words_, word);
    if (found != words_.end()) return std::size_t(found - words_.begin());
    words_.push_back(word);
    return words_.size() - 1;
  }
  const std::vector<std::string>& words() const { return words_; }

 private:
  std::vector<std::string> words_;
};

// Okabe and Ito's colours, which the colour-blind can tell apart, without their yellow.
const std::vector<std::string> colours{"#999999", "#E69F00", "#56B4E9", "#009E73", "#CC79A7", "#0072B2", "#D55E00"};
const std::vector<int> points{1, 2, 4, 6, 8, 10, 12, 3, 14};

std::string mark(std::size_t i) {
  return "pointtype " + std::to_string(points[i % points.size()]);
}
std::string colour(std::size_t i) {
  return "linecolor rgb '" + colours[i % colours.size()] + "'";
}

std::string points_of(const Table& rows) {
  std::string text;
  for (const Row& row : rows)
    if (row.error > 0 && std::isfinite(row.error) && row.cost > 0)
      text += number(row.cost) + ' ' + number(100 * row.error) + '\n';
  return text;
}

/// Rows by method, those without a point left out.
std::map<Method, Table> lines_of(const Table& rows) {
  std::map<Method, Table> lines;
  for (const Row& row : rows)
    if (!points_of({row}).empty()) lines[row.method].push_back(row);
  return lines;
}

/// What a point's form stands for: all of a method that is not its shape.
std::string scheme(const Method& m) {
  return m.integrator + ' ' + m.transfer + (m.scalar == "float" ? ", float" : "");
}

}  // namespace

bool draw(const Table& rows, const std::string& title, const std::filesystem::path& png) {
  const program::Gnuplot gnuplot(png);
  Key shapes, schemes;
  for (const Row& row : rows) shapes[row.method.shape], schemes[scheme(row.method)];
  std::string data, plot;
  std::size_t index = 0;
  const auto add = [&](const std::string& block, const std::string& style) {
    data += block + "\n\n";
    plot += (plot.empty() ? "plot " : ", ") + ("'lines' index " + std::to_string(index++)) + " with " + style;
  };
  for (const auto& [method, line] : lines_of(rows))
    add(points_of(line), "linespoints linewidth 1 pointsize 0.9 " + colour(shapes[method.shape]) + ' ' +
                             mark(schemes[scheme(method)]) + " notitle");
  add(points_of(front(rows)), "linespoints linewidth 3 pointtype 7 pointsize 0.7 linecolor rgb 'black' title 'front'");
  for (const std::string& shape : shapes.words())
    plot += ", NaN with lines linewidth 4 " + colour(shapes[shape]) + " title " + gnuplot_string(shape);
  for (const std::string& s : schemes.words())
    plot += ", NaN with points pointsize 1.2 linecolor rgb 'black' " + mark(schemes[s]) + " title " + gnuplot_string(s);
  mpm::io::replace_file(gnuplot.folder() / "lines", data);
  return gnuplot.draw(960, 600,
                      "set label 1 " + gnuplot_string(title) +
                          " at screen 0.5,0.96 center\nset tmargin 3\nset logscale xy\nset grid\nset xlabel 'cost, "
                          "core-seconds'\nset ylabel 'error, %'\n"
                          "set format '%g'\nset key outside right top samplen 1.5 spacing 1.1\n" +
                          plot + '\n');
}

}  // namespace accuracy_cost
