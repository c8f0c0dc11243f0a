// SPDX-License-Identifier: MIT
#include <mpm/io/csv.hpp>
#include <mpm/io/text.hpp>
#include <program/gnuplot.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include "limits.hpp"

namespace mpm::atlas {
namespace {

using mpm::io::number;
using program::gnuplot_string;

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}
template <class List, class F>
std::vector<std::string> words(const List& list, const F& word) {
  std::vector<std::string> found;
  for (const auto& entry : list)
    if (std::ranges::find(found, word(entry)) == found.end()) found.push_back(word(entry));
  return found;
}

void draw(const std::vector<GrowthMap>& maps, const std::filesystem::path& png) {
  const auto integrators = words(maps, [](const GrowthMap& m) { return m.integrator; });
  const std::size_t columns = maps.size() / integrators.size();
  const program::Gnuplot gnuplot(png);
  std::string panels;
  for (std::size_t n = 0; n < maps.size(); ++n) {
    const GrowthMap& m = maps[n];
    std::string cells, line;
    for (std::size_t i = 0; i < m.offsets.size(); ++i) {
      for (std::size_t k = 0; k < m.steps.size(); ++k)
        cells += number(m.offsets[i]) + ' ' + number(m.steps[k]) + ' ' +
                 number(std::clamp(std::log10(m.growth[i * m.steps.size() + k]), 0., 1.)) + '\n';
      line += number(m.offsets[i]) + ' ' + number(m.certain[i]) + '\n';
    }
    const std::string name = std::to_string(n);
    mpm::io::replace_file(gnuplot.folder() / ("cells" + name), cells);
    mpm::io::replace_file(gnuplot.folder() / ("line" + name), line);
    const bool left = n % columns == 0, bottom = n / columns + 1 == integrators.size();
    panels += "set title " + gnuplot_string(n < columns ? std::to_string(m.per_edge) + " an edge" : "") +
              "\nset label 1 " + gnuplot_string(left ? m.integrator : "") + " at graph -0.2,0.5 right\nset format y " +
              (left ? "'%g'" : "''") + "\nset format x " + (bottom ? "'%g'" : "''") + "\nplot 'cells" + name +
              "' with image notitle, 'line" + name + "' with lines linewidth 3 linecolor rgb 'black' notitle\n";
  }
  const double width = double(170 * columns + 220), height = double(110 * integrators.size() + 120);
  const auto share = [](double pixels, double of) { return ',' + number(pixels / of); };
  gnuplot.draw(int(width), int(height),
               "set multiplot layout " + std::to_string(integrators.size()) + ',' + std::to_string(columns) +
                   " margins " + number(205 / width) + share(width - 15, width) + share(35, height) +
                   share(height - 80, height) + " spacing " + number(12 / width) + share(8, height) + " title " +
                   gnuplot_string(maps.front().shape + ", " + maps.front().space +
                                  ": growth over offset (h) and step (h/c); line: certain step") +
                   " font ',12'" +
                   "\nset xrange [0:1]\nset yrange [0:2.45]\nset xtics (0, .5)\nset ytics 1\nset cbrange [0:1]\n"
                   "set palette defined (0 'white', 0.02 '#FFE9A0', 0.3 '#E69F00', 1 '#8B1A00')\nunset colorbox\n" +
                   panels + "unset multiplot\n");
}

}  // namespace

void write(const std::vector<GrowthMap>& maps, const std::filesystem::path& file) {
  mpm::io::CsvWriter out(file, {{"space", "1"},
                                {"shape", "1"},
                                {"integrator", "1"},
                                {"per edge", "1"},
                                {"offset", "h"},
                                {"step", "h/c"},
                                {"certain step", "h/c"},
                                {"growth a step", "1"}});
  for (const GrowthMap& map : maps)
    for (std::size_t i = 0; i < map.offsets.size(); ++i)
      for (std::size_t k = 0; k < map.steps.size(); ++k)
        out.row(std::vector<std::string>{map.space, map.shape, map.integrator, std::to_string(map.per_edge),
                                         number(map.offsets[i]), number(map.steps[k]), number(map.certain[i]),
                                         number(map.growth[i * map.steps.size() + k])});
}

void write(const std::vector<Limit>& limits, const std::filesystem::path& file) {
  mpm::io::CsvWriter out(file, {{"space", "1"},
                                {"shape", "1"},
                                {"integrator", "1"},
                                {"per edge", "1"},
                                {"certain step", "h/c"},
                                {"limit", "h/c"},
                                {"nodal limit", "h/c"},
                                {"mean share", "1"}});
  for (const Limit& l : limits)
    out.row(std::vector<std::string>{l.space, l.shape, l.integrator, std::to_string(l.per_edge), number(l.certain),
                                     number(l.limit), number(l.nodal), number(l.share)});
}

void draw_each(const std::vector<GrowthMap>& maps, const std::filesystem::path& folder) {
  const auto picture = [](const GrowthMap& m) { return "growth_" + m.space + '_' + m.shape + ".png"; };
  for (const std::string& name : words(maps, picture)) {
    std::vector<GrowthMap> drawn;
    std::ranges::copy_if(maps, std::back_inserter(drawn), [&](const GrowthMap& m) { return picture(m) == name; });
    draw(drawn, folder / name);
  }
}

bool draw(const std::vector<Limit>& all, const std::filesystem::path& png) {
  static const std::vector<std::string> colours{"#000000", "#E69F00", "#56B4E9", "#009E73", "#CC79A7", "#0072B2"};
  std::vector<Limit> line;
  std::ranges::copy_if(all, std::back_inserter(line), [](const Limit& l) { return l.space == "1-D"; });
  const auto shapes = words(line, [](const Limit& l) { return l.shape; });
  const program::Gnuplot gnuplot(png);
  std::string panels;
  for (const char* integrator : {"USL", "MUSL"}) {
    std::string plot;
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      std::string rows;
      for (const Limit& l : line)
        if (l.shape == shapes[s] && l.integrator == integrator)
          rows += std::to_string(l.per_edge) + ' ' + number(l.limit) + ' ' + number(l.certain) + '\n';
      const std::string file = integrator + std::to_string(s), colour = " linecolor rgb '" + colours[s % 6] + "'";
      mpm::io::replace_file(gnuplot.folder() / file, rows);
      plot += (plot.empty() ? "plot '" : ", '") + file + "' using 1:2 with linespoints pointtype " +
              std::to_string(4 + s) + " linewidth 2" + colour + " title " + gnuplot_string(shapes[s]) + ", '" + file +
              "' using 1:3 with lines dashtype 2 linewidth 2" + colour + " notitle";
    }
    panels += "set title '" + std::string(integrator) + ": limit (solid) and certain step (dashed)'\n" + plot + '\n';
  }
  return gnuplot.draw(1100, 560,
                      "set multiplot layout 1,2\nset logscale x\nset xrange [1:20]\nset xtics (1,2,3,4,6,8,12,20)\n"
                      "set yrange [0:3.5]\nset grid\nset key below\nset xlabel 'particles a cell'\n"
                      "set ylabel 'step, h/c, least of all offsets'\n" +
                          panels + "unset multiplot\n");
}

std::string markdown(const std::vector<Limit>& limits) {
  std::string text =
      "| space | shape | integrator | certain step, h/c | limit, h/c | mean share | 2/w of the nodes, h/c |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const Limit& l : limits)
    if (l.per_edge == 2)
      text += "| " + l.space + " | " + l.shape + " | " + l.integrator + " | " + rounded(l.certain) + " | " +
              rounded(l.limit) + " | " + rounded(l.share) + " | " + rounded(l.nodal) + " |\n";
  return text;
}

}  // namespace mpm::atlas
