// SPDX-License-Identifier: MIT
#include "pictures.hpp"
#include <program/gnuplot.hpp>
#include <mpm/io/text.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace blasting {
namespace {

using mpm::io::number;
using program::Gnuplot;
using program::gnuplot_string;

/// A rectangle of square pixels; row 0 is the lowest.
struct Raster {
  Vec2 corner{};     ///< lower left, m
  double pixel = 1;  ///< m
  int side = 0;      ///< pixels
  std::vector<float> values{};

  /// Index of the first pixel whose centre is not below `x`, within the raster.
  int first(double x, int axis) const {
    return static_cast<int>(std::clamp(std::ceil((x - corner[axis]) / pixel - 0.5), 0.0, double(side)));
  }

  /// Fills a polygon by the even-odd rule. Pixels belong to one of two neighbours only: edges are half-open, and an
  /// edge is cut the same way from either side.
  void fill(const Quad& quad, float value) {
    const auto [low, high] = std::ranges::minmax(quad, {}, [](const Vec2& p) { return p[1]; });
    for (int row = first(low[1], 1), end = first(high[1], 1); row < end; ++row) {
      const double y = corner[1] + (row + 0.5) * pixel;
      constexpr double none = std::numeric_limits<double>::infinity();
      std::array<double, 4> cuts{none, none, none, none};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto [a, b] = std::minmax(quad[k], quad[(k + 1) % 4]);
        if ((a[1] <= y) != (b[1] <= y)) cuts[count++] = a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
      }
      std::ranges::sort(cuts);
      for (std::size_t k = 0; k + 1 < count; k += 2) {
        const auto line = values.begin() + std::ptrdiff_t{row} * side;
        std::fill(line + first(cuts[k], 0), line + std::max(first(cuts[k], 0), first(cuts[k + 1], 0)), value);
      }
    }
  }
};

Raster window(const Picture& picture) {
  const int side = picture.quarter ? picture_pixels / 2 : picture_pixels;
  const double left = picture.quarter ? 0 : -picture.half_width;
  return {{picture.centre[0] + left, picture.centre[1] + left},
          2 * picture.half_width / picture_pixels,
          side,
          std::vector<float>(std::size_t(side) * std::size_t(side), std::numeric_limits<float>::quiet_NaN())};
}

/// The four quadrants from the upper right one.
std::vector<float> mirrored(const std::vector<float>& quadrant) {
  constexpr int half = picture_pixels / 2;
  std::vector<float> all(std::size_t(picture_pixels) * picture_pixels);
  const auto fold = [](int i) { return i < half ? half - 1 - i : i - half; };
  for (int row = 0; row < picture_pixels; ++row)
    for (int i = 0; i < picture_pixels; ++i) all[row * picture_pixels + i] = quadrant[fold(row) * half + fold(i)];
  return all;
}

/// The value below which a share of the sorted `values` lies.
float percentile(const std::vector<float>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// The ends of the colour bar for what is seen.
std::pair<double, double> range(ColourMap colours, std::vector<float> seen) {
  if (colours == ColourMap::damage) return {-1, 1};
  std::erase_if(seen, [](float value) { return !std::isfinite(value); });
  if (seen.empty()) return {-1, 1};
  const bool symmetric = colours == ColourMap::diverging;
  if (symmetric) std::ranges::transform(seen, seen.begin(), [](float value) { return std::abs(value); });
  std::ranges::sort(seen);
  const double high = percentile(seen, symmetric ? 0.98 : 0.99);
  const double low = symmetric ? -high : percentile(seen, 0.01);
  return high > low ? std::pair{low, high} : std::pair{low - 1, high + 1};
}

// The canvas: the window with room for axes, title and colour bar, pixels.
constexpr int left = 120, right = 240, bottom = 95, top = 75;
constexpr int width = left + picture_pixels + right, height = bottom + picture_pixels + top;

/// Margins that give each pixel of the raster one of the picture.
std::string margins() {
  const auto share = [](int pixels, int of) { return number(double(pixels) / of) + "\n"; };
  return "set lmargin at screen " + share(left, width) + "set rmargin at screen " +
         share(left + picture_pixels, width) + "set bmargin at screen " + share(bottom, height) +
         "set tmargin at screen " + share(bottom + picture_pixels, height);
}

std::string field_script(const Picture& picture, std::pair<double, double> bar) {
  const auto& [x, y] = picture.centre;
  const double w = picture.half_width, pixel = 2 * w / picture_pixels;
  const auto span = [&](double c) { return "[" + number(c - w) + ":" + number(c + w) + "]\n"; };
  const std::string unit = picture.field.unit == "1" ? "" : " [" + picture.field.unit + "]";
  const std::string side = std::to_string(picture_pixels);
  return margins() + palette(picture.field.colours) + "set title " + gnuplot_string(picture.title) +
         " font 'Sans,18'\nset xlabel 'x [m]'\nset ylabel 'y [m]'\nset cblabel " +
         gnuplot_string(picture.field.name + unit) + "\nset xrange " + span(x) + "set yrange " + span(y) +
         "set cbrange [" + number(bar.first) + ":" + number(bar.second) +
         "]\nset tics out nomirror\nunset key\n"
         "set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '#d9dde2' fillstyle solid "
         "noborder\n" +
         circles(picture.holes, picture.hole_radius) + "plot 'field' binary array=(" + side + "," + side +
         ") format='%float' dx=" + number(pixel) + " dy=" + number(pixel) + " origin=(" + number(x - w + pixel / 2) +
         "," + number(y - w + pixel / 2) + ") with image\n";
}

struct Table {
  std::vector<std::string> names{};
  bool has_rows = false;
};

/// The columns' names, `name [unit]` without the unit.
Table read_header(const std::filesystem::path& csv) {
  std::ifstream in(csv);
  std::string line;
  if (!std::getline(in, line)) throw std::runtime_error(csv.string() + ": cannot be read");
  Table table;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::string column = line.substr(begin, end - begin);
    table.names.push_back(column.substr(0, column.rfind(" [")));
    begin = end + 1;
  }
  table.has_rows = bool(std::getline(in, line));
  return table;
}

}  // namespace

std::string circles(const std::vector<Vec2>& centres, double radius) {
  std::string script;
  int object = 2;
  for (const auto& [x, y] : centres)
    script += "set object " + std::to_string(object++) + " circle at " + number(x) + "," + number(y) + " size " +
              number(radius) + " front fillstyle empty border rgb '#00a0a0' linewidth 1.5\n";
  return script;
}

std::string palette(ColourMap colours) {
  switch (colours) {
    case ColourMap::sequential:
      return "set palette defined (0 '#0b0724', 1 '#4a1079', 2 '#a1307e', 3 '#ee5b5e', 4 '#fea973', 5 '#fcfbc0')\n";
    case ColourMap::diverging:
      return "set palette defined (0 '#0a2f6b', 1 '#2f7ebc', 2 '#a6cfe4', 3 '#fbfaf7', 4 '#f6b394', 5 '#cf4a41', "
             "6 '#6d0220')\n";
    case ColourMap::damage:
      return "set palette defined (-1 '#7d0a12', -0.6 '#cf3a1e', -0.2 '#f3b27a', 0 '#f6f0e2', 0.2 '#c3c0b8', "
             "0.6 '#59616d', 1 '#0c1018')\n"
             "set cbtics ('crushed' -1, '0.5' -0.5, 'intact' 0, '0.5' 0.5, 'cracked' 1)\n";
  }
  throw std::invalid_argument("unknown colour map");
}

std::vector<float> rasterise(const Picture& picture, std::span<const Quad> domains, std::span<const double> values) {
  if (domains.size() != values.size())
    throw std::invalid_argument("picture `" + picture.title + "`: " + std::to_string(values.size()) + " values for " +
                                std::to_string(domains.size()) + " particles");
  Raster raster = window(picture);
  for (std::size_t p = 0; p < domains.size(); ++p) raster.fill(domains[p], static_cast<float>(values[p]));
  return picture.quarter ? mirrored(raster.values) : raster.values;
}

bool draw_field(const Picture& picture, std::span<const Quad> domains, std::span<const double> values,
                const std::filesystem::path& png) {
  auto seen = rasterise(picture, domains, values);
  for (float& value : seen) value *= static_cast<float>(picture.field.scale);
  const Gnuplot gnuplot(png);
  mpm::io::replace_file(gnuplot.folder() / "field",
                        {reinterpret_cast<const char*>(seen.data()), seen.size() * sizeof(float)});
  return gnuplot.draw(width, height, field_script(picture, range(picture.field.colours, seen)));
}

bool draw_chart(const Chart& chart, const std::filesystem::path& csv, const std::filesystem::path& png) {
  const Table table = read_header(csv);
  if (!table.has_rows) throw std::runtime_error(csv.string() + ": no row to draw");
  const auto columns = chart.columns.empty() ? std::vector(table.names.begin() + 1, table.names.end()) : chart.columns;
  std::string curves;
  for (const auto& name : columns) {
    const auto found = std::ranges::find(table.names, name);
    if (found == table.names.end()) throw std::invalid_argument(csv.string() + ": no column `" + name + "`");
    curves += (curves.empty() ? "plot " : ", ") + std::string("'table' skip 1 using (1e6*column(1)):(") +
              number(chart.scale) + "*column(" + std::to_string(found - table.names.begin() + 1) +
              ")) with lines linewidth 2 title " + gnuplot_string(name);
  }
  const Gnuplot gnuplot(png);
  std::filesystem::copy_file(csv, gnuplot.folder() / "table");
  return gnuplot.draw(1200, 720,
                      "set datafile separator comma\nset title " + gnuplot_string(chart.title) +
                          " font 'Sans,18'\nset xlabel 'time [µs]'\nset ylabel " +
                          gnuplot_string(chart.quantity + " [" + chart.unit + "]") +
                          "\nset grid linetype 1 linecolor rgb '#d5d5d5'\nset border 3\nset tics out nomirror\n"
                          "set key outside right top Left reverse\n" +
                          curves + "\n");
}

}  // namespace blasting
