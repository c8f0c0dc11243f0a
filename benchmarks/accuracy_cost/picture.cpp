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
const std::vector<int> points{1, 2, 4, 6, 8, 10, 12, 3, 14, 5, 9, 13};

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

/// What a line's colour stands for.
std::string coloured(const Method& m) {
  return m.scene.empty() ? m.shape : m.scene;
}
/// What a point's form stands for: all of a method that is not its shape; the scene again, so that lines which fall on
/// each other show.
std::string scheme(const Method& m) {
  if (!m.scene.empty()) return m.scene;
  return m.integrator + ' ' + m.transfer + (m.scalar == "float" ? ", float" : "");
}

}  // namespace

bool draw(const Table& rows, const std::string& title, const std::filesystem::path& png) {
  const program::Gnuplot gnuplot(png);
  Key colours_of, schemes;
  for (const Row& row : rows) colours_of[coloured(row.method)], schemes[scheme(row.method)];
  std::string data, plot;
  std::size_t index = 0;
  const auto add = [&](const std::string& block, const std::string& style) {
    data += block + "\n\n";
    plot += (plot.empty() ? "plot " : ", ") + ("'lines' index " + std::to_string(index++)) + " with " + style;
  };
  const bool scenes = colours_of.words() == schemes.words();
  // Of scenes one may be the whole front, which then must not hide it.
  const std::string front_style = scenes ? "lines linewidth 12 linecolor rgb '#dddddd' title 'front'"
                                         : "linespoints linewidth 3 pointtype 7 pointsize 0.7 linecolor rgb 'black' "
                                           "title 'front'";
  if (scenes) add(points_of(front(rows)), front_style);
  for (const auto& [method, line] : lines_of(rows))
    add(points_of(line), "linespoints linewidth 1 pointsize 0.9 " + colour(colours_of[coloured(method)]) + ' ' +
                             mark(schemes[scheme(method)]) + " notitle");
  if (!scenes) add(points_of(front(rows)), front_style);
  for (const std::string& word : colours_of.words())
    plot += ", NaN with " + (scenes ? "linespoints " + mark(schemes[word]) : "lines") + " linewidth " +
            (scenes ? "1 " : "4 ") + colour(colours_of[word]) + " title " + gnuplot_string(word);
  for (const std::string& s : scenes ? std::vector<std::string>{} : schemes.words())
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
