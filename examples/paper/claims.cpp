// SPDX-License-Identifier: MIT
#include "claims.hpp"
#include <mpm/io/text.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace paper {
namespace {

State equiaxial(double level) {
  return {level, level};
}
State lateral(double k) {
  return {k * vertical_stress, vertical_stress};
}

template <class Range, class F>
std::vector<double> over(const Range& range, const F& f) {
  std::vector<double> values;
  for (const double x : range) values.push_back(f(x));
  return values;
}

bool falls(const std::vector<double>& values) {
  return std::ranges::adjacent_find(values, std::less_equal<>{}) == values.end();
}

std::string joined(const std::vector<double>& values, double scale, int digits) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + fixed(scale * value, digits);
  return text;
}

std::vector<Finding> judge_levels(const States& s) {
  const auto get = [&](double Measured::*member) {
    return over(equiaxial_levels, [&](double level) { return s.at(equiaxial(level)).*member; });
  };
  const auto reach = get(&Measured::reach), area = get(&Measured::area), x = get(&Measured::along_x),
             y = get(&Measured::along_y), compression = get(&Measured::compression), tension = get(&Measured::tension);
  double uneven = 0;
  for (std::size_t i = 0; i < x.size(); ++i) uneven = std::max(uneven, std::abs(y[i] / x[i] - 1));
  const double share = area.back() / area.front(), late = s.at(equiaxial(50)).late_growth;
  return {
      {"Crack length falls with the in-situ stress over 0, 10, 20, 30, 40, 50 MPa",
       "reach " + joined(reach, 1e3, 0) + " mm", falls(reach)},
      {"So does the damaged area, at 50 MPa to between .35 and .55 of that at 0",
       joined(area, 1e4, 0) + " cm2, ratio " + fixed(share, 2), falls(area) && share >= .35 && share <= .55},
      {"At 50 MPa the cracks have stopped before the end: at most 2 % longer in the last fifth of the time",
       fixed(100 * late, 1) + " % (at 0 MPa " + fixed(100 * s.at(equiaxial(0)).late_growth, 1) + " %)", late <= .02},
      {"Cracks are almost as long along x as along y under equal stresses: within 20 %",
       "largest difference " + fixed(100 * uneven, 0) + " %", uneven <= .2},
      {"In-situ stress raises the compressive stress of the blast, .8 m from the hole",
       "peaks " + joined(compression, -1e-6, 0) + " MPa", compression.back() < compression.front()},
      {"and lowers the tensile stress there", "peaks " + joined(tension, 1e-6, 1) + " MPa",
       tension.back() < tension.front()},
  };
}

std::vector<Finding> judge_ratios(const States& s) {
  const auto get = [&](double Measured::*member) {
    return over(lateral_ratios, [&](double k) { return s.at(lateral(k)).*member; });
  };
  const auto H = get(&Measured::along_x), V = get(&Measured::along_y), longest = get(&Measured::longest);
  const auto ratio = [&](std::size_t i) { return V[i] / H[i]; };
  const auto [shortest, farthest] = std::ranges::minmax(std::vector(H.begin() + 2, H.end()));
  return {
      {"k &lt; 1: cracks along y, the larger stress, are longer; V/H at least 1.25 at k = .25",
       "V/H " + fixed(ratio(0), 2) + ", " + fixed(ratio(1), 2) + " at .25, .5", ratio(0) >= 1.25 && ratio(1) > 1},
      {"k &gt; 1: cracks along x are longer; V/H at most .6 at k = 3",
       "V/H " + fixed(ratio(3), 2) + ", " + fixed(ratio(4), 2) + ", " + fixed(ratio(5), 2) + " at 1.5, 2, 3",
       ratio(5) <= .6 && ratio(3) < 1 && ratio(4) < 1},
      {"The longest crack points along the larger stress, within 30 degrees, where they differ",
       joined({longest[0], longest[1], longest[3], longest[4], longest[5]}, 1, 0) + " degrees from x",
       longest[0] >= 60 && longest[1] >= 60 && longest[3] <= 30 && longest[4] <= 30 && longest[5] <= 30},
      {"V falls with k over .25, .5, 1, 1.5, 2, 3", "V " + joined(V, 1e3, 0) + " mm", falls(V)},
      {"H changes little with k from 1 to 3: by less than a third", "H " + joined(H, 1e3, 0) + " mm",
       farthest < shortest * 4 / 3},
      {"At k = 2 and 3 cracks along y hardly form: less than half of those at k = .25",
       fixed(V[4] / V[0], 2) + ", " + fixed(V[5] / V[0], 2), V[4] < .5 * V[0] && V[5] < .5 * V[0]},
  };
}

Finding judge_zones(const States& s) {
  bool holds = true;
  double least = 1e9, most = 0;
  for (const auto& [state, m] : s) {
    holds = holds && m.hole < m.crushed && m.crushed < m.reach && m.reach < m.half_side;
    least = std::min(least, m.crushed), most = std::max(most, m.crushed);
  }
  return {"Outward from the hole: a crushed zone, a cracked zone, elastic rock",
          "crushed to " + fixed(1e3 * least, 0) + " to " + fixed(1e3 * most, 0) + " mm, cracked beyond", holds};
}

}  // namespace

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

Measured measure(const Blast& blast) {
  const auto& scene = blast.scene;
  Measured m{.reach = blast.number("crack.reach"),
             .along_x = blast.number("crack.along_x"),
             .along_y = blast.number("crack.along_y"),
             .area = blast.number("crack.area"),
             .hole = scene.hole.radius,
             .half_side = scene.block.side / 2};
  m.crushed = std::sqrt(m.hole * m.hole + blast.number("crack.crushed_area") / std::numbers::pi);

  const auto cracks = blast.table("cracks.csv");
  const auto &time = cracks.at("time"), &reach = cracks.at("reach");
  std::size_t before = 0;
  while (before + 1 < time.size() && time[before + 1] <= .8 * scene.end_time) ++before;
  m.late_growth = reach.back() / reach[before] - 1;

  const auto rose = blast.table("rose.csv");
  const auto& by_direction = rose.at("reach");
  const double direction =
      rose.at("direction")[std::size_t(std::ranges::max_element(by_direction) - by_direction.begin())];
  const double folded = std::fmod(direction, 180);
  m.longest = std::min(folded, 180 - folded);

  const auto probes = blast.table("probes.csv");
  const std::string at = "_at_" + mpm::io::number(probe_radius) + "m";
  m.compression = std::ranges::min(probes.at("radial_stress" + at));
  m.tension = std::ranges::max(probes.at("hoop_stress" + at));
  return m;
}

std::vector<Finding> judge(const States& states) {
  auto findings = judge_levels(states);
  for (auto& finding : judge_ratios(states)) findings.push_back(std::move(finding));
  findings.push_back(judge_zones(states));
  return findings;
}

}  // namespace paper
