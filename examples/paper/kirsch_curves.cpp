// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include <mpm/analysis/kirsch.hpp>
#include <mpm/io/text.hpp>
#include <cmath>
#include <numbers>

namespace paper {
namespace {

using mpm::analysis::Kirsch;

constexpr double hole = .021;  // m

Kirsch field(double horizontal, double vertical) {
  return {.horizontal = -horizontal, .vertical = -vertical, .radius = hole};  // MPa
}
std::string k_is(double k) {
  return "k = " + mpm::io::number(k);
}
std::string megapascals(double level) {
  return fixed(level, 0) + " MPa";
}

Curve round_the_wall(const std::string& name, const Kirsch& kirsch) {
  Curve curve{.name = name};
  for (int degrees = 0; degrees <= 360; degrees += 2) {
    curve.x.push_back(degrees);
    curve.y.push_back(kirsch.polar_stress(hole, degrees * std::numbers::pi / 180).tt);
  }
  return curve;
}
Curve outward(const std::string& name, const Kirsch& kirsch, double degrees,
              double mpm::analysis::PolarStress::*component, const char* style) {
  Curve curve{.name = name, .style = style};
  for (double r = 1; r <= 10.001; r += .05) {
    curve.x.push_back(r);
    curve.y.push_back(kirsch.polar_stress(r * hole, degrees * std::numbers::pi / 180).*component);
  }
  return curve;
}

Axes along(const std::string& title, double degrees) {
  Axes axes{.title = title + ": hoop solid, radial dashed",
            .x = "r/a",
            .y = "stress, MPa",
            .extra = "set xrange [1:10]\nset key outside right\n"};
  const char* colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
  for (std::size_t i = 0; i < lateral_ratios.size(); ++i) {
    const auto kirsch = field(lateral_ratios[i] * vertical_stress, vertical_stress);
    const std::string colour = std::string("linewidth 2 linecolor rgb '") + colours[i] + "'";
    axes.curves.push_back(outward(k_is(lateral_ratios[i]), kirsch, degrees, &mpm::analysis::PolarStress::tt,
                                  ("lines " + colour).c_str()));
    axes.curves.push_back(
        outward("", kirsch, degrees, &mpm::analysis::PolarStress::rr, ("lines dashtype 2 " + colour).c_str()));
  }
  return axes;
}

}  // namespace

void kirsch_curves(Report& report) {
  const std::string angle = "angle from x, degrees", wall = "hoop stress on the wall, MPa";
  const std::string around = "set xrange [0:360]\nset xtics 90\nset key outside right\n",
                    out = "set xtics autofreq\nset xrange [1:10]\nset key outside right\n";
  Axes a{"(a) equal stresses", angle, wall, {}, around + "set yrange [-110:0]\n"},
      b{"(b) 40 MPa along y, k times that along x", angle, wall, {}, around};
  Axes c{"(c) equal stresses", "r/a", "radial stress, MPa", {}, out},
      d{"(d) equal stresses", "r/a", "hoop stress, MPa", {}, out};
  for (const double level : equiaxial_levels) {
    if (level == 0) continue;
    const auto kirsch = field(level, level);
    a.curves.push_back(round_the_wall(megapascals(level), kirsch));
    c.curves.push_back(outward(megapascals(level), kirsch, 0, &mpm::analysis::PolarStress::rr, "lines linewidth 2"));
    d.curves.push_back(outward(megapascals(level), kirsch, 0, &mpm::analysis::PolarStress::tt, "lines linewidth 2"));
  }
  for (const double k : lateral_ratios)
    b.curves.push_back(round_the_wall(k_is(k), field(k * vertical_stress, vertical_stress)));
  draw_curves({a, b, c, d, along("(e) along x", 0), along("(f) along y", 90)}, 2, report.folder / "fig8.png");

  const double least = field(.25 * vertical_stress, vertical_stress).polar_stress(hole, std::numbers::pi / 2).tt;
  double next = -1e9;
  for (std::size_t i = 1; i < lateral_ratios.size(); ++i)
    for (const double degrees : {0., 90.})
      next = std::max(next, field(lateral_ratios[i] * vertical_stress, vertical_stress)
                                .polar_stress(hole, degrees * std::numbers::pi / 180)
                                .tt);
  report.findings.push_back(
      {"Fig. 8: the wall is in tension along y at k = .25, and nowhere for larger k",
       "hoop stress there " + fixed(least, 0) + " MPa; for larger k at most " + fixed(next, 0) + " MPa",
       least > 0 && next <= 1e-9});
  report.page.section("Fig. 8: stress round the hole, exact", "fig8");
  report.page.figure(report.folder, "fig8.png",
                     "Kirsch's solution, Eq 12 with its shear corrected; the hole's radius a is 21 mm. (e) and (f): "
                     "40 MPa along y, k times that along x. Stresses are positive in tension.");
}

}  // namespace paper
