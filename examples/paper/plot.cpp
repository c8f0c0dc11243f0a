// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include <mpm/io/csv.hpp>
#include <program/gnuplot.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace paper {
namespace {

using mpm::io::number;
using program::gnuplot_string;

// Okabe and Ito's colours, which the colour-blind can tell apart, without their yellow.
const std::vector<std::string> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};

std::string plain(std::string text) {
  for (char& c : text) c = c == ',' ? ';' : c;
  return text;
}

void write_csv(const std::vector<Axes>& panels, std::filesystem::path csv) {
  mpm::io::CsvWriter table(csv.replace_extension(".csv"), {{"panel", "1"}, {"curve", "1"}, {"x", "1"}, {"y", "1"}});
  for (const auto& panel : panels)
    for (const auto& curve : panel.curves)
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const std::string row[] = {plain(panel.title + " (" + panel.x + "; " + panel.y + ")"), plain(curve.name),
                                   number(curve.x[i]), number(curve.y[i])};
        table.row(row);
      }
}

/// Means of the squares of `factor` by `factor` pixels; NaN where one of them is.
std::vector<float> reduced(const std::vector<float>& values, int factor) {
  constexpr int full = blasting::picture_pixels;
  const int side = full / factor;
  std::vector<float> small(std::size_t(side) * std::size_t(side));
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      float sum = 0;
      for (int j = 0; j < factor; ++j)
        for (int i = 0; i < factor; ++i)
          sum += values[std::size_t(row * factor + j) * full + std::size_t(column * factor + i)];
      small[std::size_t(row) * std::size_t(side) + std::size_t(column)] = sum / float(factor * factor);
    }
  return small;
}

// Room around the tiles, pixels.
constexpr int gap = 16, heading = 30, bar = 130;

}  // namespace

void draw_curves(const std::vector<Axes>& panels, int columns, const std::filesystem::path& png) {
  write_csv(panels, png);
  const program::Gnuplot gnuplot(png);
  const int rows = (int(panels.size()) + columns - 1) / columns;
  std::string script = "set multiplot layout " + std::to_string(rows) + "," + std::to_string(columns) +
                       "\nset grid linetype 1 linecolor rgb '#e0e0e0'\nset tics out nomirror\n";
  std::string data;
  int index = 0;
  for (const auto& panel : panels) {
    std::string plots;
    std::size_t colour = 0;
    for (const auto& curve : panel.curves) {
      for (std::size_t i = 0; i < curve.x.size(); ++i) data += number(curve.x[i]) + ' ' + number(curve.y[i]) + '\n';
      data += "\n\n";
      std::string style = curve.style;
      if (style.find("linecolor") == style.npos) style += " linecolor rgb '" + colours[colour++ % colours.size()] + "'";
      plots += (plots.empty() ? "plot " : ", ") + ("'curves' index " + std::to_string(index++)) + " with " + style +
               (curve.name.empty() ? " notitle" : " title " + gnuplot_string(curve.name));
    }
    script += "set title " + gnuplot_string(panel.title) + "\nset xlabel " + gnuplot_string(panel.x) + "\nset ylabel " +
              gnuplot_string(panel.y) + "\nset autoscale\nset size noratio\nset key top right\n" + panel.extra + plots +
              '\n';
  }
  mpm::io::replace_file(gnuplot.folder() / "curves", data);
  gnuplot.draw(columns == 1 ? 900 : 620 * columns, 430 * rows, script + "unset multiplot\n");
}

void draw_tiles(const std::vector<Tile>& tiles, const TileStyle& style, const std::filesystem::path& png) {
  const program::Gnuplot gnuplot(png);
  const int rows = (int(tiles.size()) + style.columns - 1) / style.columns;
  const int width = style.columns * (style.pixels + gap) + gap + bar, height = rows * (style.pixels + heading) + gap;
  const double w = style.half_width, pixel = 2 * w / style.pixels;
  const auto share = [](int pixels, int of) { return number(double(pixels) / of); };
  const std::string span = "[" + number(-w) + ":" + number(w) + "]\n", side = std::to_string(style.pixels);
  std::string script = "set multiplot\n" + blasting::palette(style.colours) + "set cbrange [" + number(style.low) +
                       ":" + number(style.high) + "]\nset cblabel " + gnuplot_string(style.quantity) +
                       "\nunset key\nunset xtics\nunset ytics\nset border 31 linecolor rgb '#909090'\nset xrange " +
                       span + "set yrange " + span;
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    const int left = gap + int(k) % style.columns * (style.pixels + gap);
    const int top = height - heading - int(k) / style.columns * (style.pixels + heading);
    auto values = reduced(tiles[k].values, blasting::picture_pixels / style.pixels);
    if (style.colours == blasting::ColourMap::damage)  // few shades make small files
      for (float& value : values) value = std::round(8 * value) / 8;
    const std::string name = "tile" + std::to_string(k);
    mpm::io::replace_file(gnuplot.folder() / name,
                          {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)});
    script += "set lmargin at screen " + share(left, width) + "\nset rmargin at screen " +
              share(left + style.pixels, width) + "\nset tmargin at screen " + share(top, height) +
              "\nset bmargin at screen " + share(top - style.pixels, height) + "\nset label 1 " +
              gnuplot_string(tiles[k].title) + " at screen " + share(left + style.pixels / 2, width) + "," +
              share(top + heading / 2 - 2, height) + " center\n";
    script += k > 0 ? "unset colorbox\n"
                    : "set colorbox user origin screen " + share(width - bar + gap, width) + ",0.3 size screen " +
                          share(20, width) + ",0.4\n";
    script += blasting::circles(tiles[k].holes, style.hole) + "plot '" + name + "' binary array=(" + side + "," + side +
              ") format='%float' dx=" + number(pixel) + " dy=" + number(pixel) + " origin=(" + number(-w + pixel / 2) +
              "," + number(-w + pixel / 2) + ") with image\nunset object\n";
  }
  gnuplot.draw(width, height, script + "unset multiplot\n");
}

}  // namespace paper
