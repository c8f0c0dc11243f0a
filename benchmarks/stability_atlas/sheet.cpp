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

using mpm::io::number;
using program::gnuplot_string;

std::string rounded(double value, const char* format = "%.2g") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}
std::string value_of(const Sheet& sheet, double y) {
  if (std::isnan(y)) return "the step vanishes";
  if (std::isinf(y)) return "the run stops";
  return sheet.percent == 1 ? rounded(y) : rounded(sheet.percent * y) + " %";
}
void add_once(std::vector<std::string>& list, const std::string& word) {
  if (std::ranges::find(list, word) == list.end()) list.push_back(word);
}
std::vector<std::string> shapes_of(const std::vector<Sheet>& sheets) {
  std::vector<std::string> shapes;
  for (const Sheet& sheet : sheets)
    for (const auto& p : sheet.points) add_once(shapes, p.shape);
  return shapes;
}
std::vector<std::string> integrators_of(const std::vector<Sheet>& sheets) {
  std::vector<std::string> integrators;
  for (const Sheet& sheet : sheets)
    for (const auto& p : sheet.points) add_once(integrators, p.integrator);
  return integrators;
}

/// The curves of a picture, as gnuplot draws them.
class Curves {
 public:
  Curves(const Sheet& sheet, const program::Gnuplot& gnuplot)
      : sheet_(sheet), file_(gnuplot.folder() / "lines"), integrators_(integrators_of({sheet})) {}

  bool by_shape() const { return integrators_.size() > 1; }
  /// A plot of what one shape has, colours by integrator; an empty panel if no run got anywhere.
  std::string of_shape(const std::string& shape) {
    std::string plot;
    for (std::size_t k = 0; k < integrators_.size(); ++k) add(plot, shape, integrators_[k], look(k), "");
    return plot.empty() ? "set multiplot next" : "plot " + plot;
  }
  /// A plot of all shapes, which have a curve each.
  std::string of_all() {
    std::string plot;
    const auto shapes = shapes_of({sheet_});
    for (std::size_t k = 0; k < shapes.size(); ++k) add(plot, shapes[k], integrators_.front(), look(k), shapes[k]);
    return plot.empty() ? "" : "plot " + plot;
  }
  /// A plot of nothing but the names of the integrators.
  std::string key() const {
    std::string plot;
    for (std::size_t k = 0; k < integrators_.size(); ++k)
      plot += (k ? ", NaN " : "plot NaN ") + look(k) + " title " + gnuplot_string(integrators_[k]);
    return plot;
  }
  void write() const { mpm::io::replace_file(file_, data_); }

 private:
  void add(std::string& plot, const std::string& shape, const std::string& integrator, const std::string& look,
           const std::string& title) {
    std::string rows;
    for (const auto& p : sheet_.points)
      if (p.shape == shape && p.integrator == integrator && std::isfinite(p.y) && (p.y > 0 || !sheet_.log_y))
        rows += number(p.x) + ' ' + number(sheet_.percent * p.y) + '\n';
    if (rows.empty()) return;
    data_ += rows + "\n\n";
    plot += (plot.empty() ? "'lines' index " : ", 'lines' index ") + std::to_string(count_++) + ' ' + look +
            (title.empty() ? " notitle" : " title " + gnuplot_string(title));
  }
  static std::string look(std::size_t k) {
    // Okabe and Ito's colours, which the colour-blind can tell apart, without their yellow.
    static const std::vector<std::string> colours{"#000000", "#E69F00", "#56B4E9", "#009E73",
                                                  "#CC79A7", "#0072B2", "#D55E00"};
    return "with linespoints linewidth 2 pointsize 0.8 pointtype " + std::to_string(4 + k % 10) + " dashtype " +
           std::to_string(1 + k / colours.size()) + " linecolor rgb '" + colours[k % colours.size()] + '\'';
  }

  const Sheet& sheet_;
  std::filesystem::path file_;
  std::vector<std::string> integrators_;
  std::string data_;
  int count_ = 0;
};

/// An axis that holds all finite values and `other`, so that panels are alike, with few marks.
std::string axis(const Sheet& sheet, char name, bool log, double factor, double Sheet::Point::*value, double other) {
  double low = 1e300, high = -1e300;
  const auto hold = [&](double v) {
    if (std::isfinite(v) && (v > 0 || !log)) low = std::min(low, v), high = std::max(high, v);
  };
  for (const auto& p : sheet.points) hold(factor * p.*value);
  hold(other);
  const double margin = log ? 1.2 : 1;
  std::string text =
      std::string("set ") + name + "range [" + number(low / margin) + ':' + number(high * margin) + "]\n";
  if (log) return text + "set logscale " + name + '\n';
  const double decade = std::pow(10, std::floor(std::log10(high - low)));
  const double decades = (high - low) / decade, mark = decades < 1.5 ? .2
                                                       : decades < 3 ? .5
                                                       : decades < 7 ? 1
                                                       : decades < 8 ? 2
                                                                     : 5;
  return text + "set " + name + "tics " + number(mark * decade) + '\n';
}

}  // namespace

std::string verdict(const Sheet& sheet, const std::string& shape, const std::string& integrator) {
  if (const auto r = sheet.refused.find(shape); r != sheet.refused.end()) return r->second;
  bool tried = false;
  double largest = 0;
  for (const Sheet::Point& p : sheet.points) {
    if (p.shape != shape || (p.integrator != integrator && !p.integrator.empty()) || p.x < sheet.judged_from) continue;
    tried = true;
    if (!(p.y <= sheet.limit)) return "**" + sheet.at + rounded(p.x, "%.3g") + "** (" + value_of(sheet, p.y) + ")";
    largest = std::max(largest, p.y);
  }
  return tried ? value_of(sheet, largest) : "";
}

std::string markdown(const std::vector<Sheet>& sheets) {
  std::string text = "| shape | integrator |", rule = "|---|---|";
  for (const Sheet& sheet : sheets) text += ' ' + sheet.mode + " |", rule += "---|";
  text += '\n' + rule + '\n';
  for (const std::string& shape : shapes_of(sheets))
    for (const std::string& integrator : integrators_of(sheets)) {
      const bool named = std::ranges::any_of(sheets, [&](const Sheet& sheet) {
        return std::ranges::any_of(sheet.points, [&](const Sheet::Point& p) {
          return p.shape == shape && p.integrator == integrator && !integrator.empty();
        });
      });
      if (!named) continue;
      text += "| " + shape + " | " + integrator + " |";
      for (const Sheet& sheet : sheets) text += ' ' + verdict(sheet, shape, integrator) + " |";
      text += '\n';
    }
  return text;
}

void write(const std::vector<Sheet>& sheets, const std::filesystem::path& file) {
  mpm::io::CsvWriter out(file, {{"sheet", "1"}, {"shape", "1"}, {"integrator", "1"}, {"x", "1"}, {"y", "1"}});
  for (const Sheet& sheet : sheets)
    for (const auto& p : sheet.points)
      out.row(std::vector<std::string>{sheet.name, p.shape, p.integrator, number(p.x), number(p.y)});
}

bool draw(const Sheet& sheet, const std::filesystem::path& png) {
  const program::Gnuplot gnuplot(png);
  Curves curves(sheet, gnuplot);
  const std::string limit = number(sheet.percent * sheet.limit);
  const std::string axes = "set grid\nset format '%g'\n" +
                           axis(sheet, 'x', sheet.log_x, 1, &Sheet::Point::x, sheet.points.front().x) +
                           axis(sheet, 'y', sheet.log_y, sheet.percent, &Sheet::Point::y, sheet.percent * sheet.limit) +
                           "set arrow 1 from graph 0, first " + limit + " to graph 1, first " + limit +
                           " nohead dashtype 2 linewidth 2 linecolor rgb '#777777'\n";
  const std::string x_label = "set xlabel " + gnuplot_string(sheet.x_label) + " font ',12'\n",
                    y_label = "set ylabel " + gnuplot_string(sheet.y_label) + " font ',12'\n";
  if (!curves.by_shape()) {
    const std::string plot = curves.of_all();
    curves.write();
    return gnuplot.draw(1000, 560,
                        axes + x_label + y_label + "set label 1 " + gnuplot_string(sheet.title) +
                            " font ',14' at screen 0.5,0.96 center\nset tmargin 3\nset key outside right top vertical "
                            "maxcols 1 samplen 1.5\n" +
                            plot + '\n');
  }
  constexpr std::size_t columns = 4;
  const auto shapes = shapes_of({sheet});
  const std::size_t rows = shapes.size() / columns + 1;  // the last panel has the names
  std::string panels;
  for (std::size_t k = 0; k < shapes.size(); ++k)
    panels += "set title " + gnuplot_string(shapes[k]) + " font ',13'\n" +
              (k + columns >= shapes.size() ? x_label : "unset xlabel\n") +
              (k % columns == 0 ? y_label : "unset ylabel\n") + curves.of_shape(shapes[k]) + '\n';
  curves.write();
  panels +=
      "unset title\nunset border\nunset tics\nunset grid\nunset arrow\nunset xlabel\nunset ylabel\n"
      "set bmargin 0\nset key left top vertical maxcols 1 samplen 3 Left reverse font ',11'\n" +
      curves.key() + '\n';
  const std::string layout = std::to_string(rows) + ',' + std::to_string(columns);
  return gnuplot.draw(1280, int(40 + 340 * rows),
                      axes + "set tics font ',11'\nset lmargin 8\nset rmargin 1\nset tmargin 3.5\nset bmargin 3\n" +
                          "set multiplot layout " + layout + " title " + gnuplot_string(sheet.title) + " font ',15'\n" +
                          panels + "unset multiplot\n");
}

}  // namespace mpm::atlas
