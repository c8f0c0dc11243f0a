// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include "snapshot.hpp"
#include "states.hpp"
#include <mpm/io/text.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace paper {
namespace {

using Blasts = std::map<State, Blast>;
constexpr int seeds = 3;

/// The paper's order: (a) to (f) equal stresses, (g) to (l) k times 40 MPa.
std::vector<std::pair<std::string, State>> in_order() {
  std::vector<std::pair<std::string, State>> order;
  char letter = 'a';
  const auto add = [&](const std::string& what, const State& state) {
    order.push_back({"(" + std::string(1, letter++) + ") " + what, state});
  };
  for (const double level : equiaxial_levels) add(fixed(level, 0) + " MPa", {level, level});
  for (const double k : lateral_ratios) add("k = " + mpm::io::number(k), {k * vertical_stress, vertical_stress});
  return order;
}

States measured(const Blasts& blasts) {
  States states;
  for (const auto& [state, blast] : blasts) states[state] = measure(blast);
  return states;
}

/// How far out the rock's damage, by rings of `width`, is of each kind.
void add_zones(Axes& axes, const Rock& rock, const std::string& name, double width) {
  std::vector<double> area_of, crushed, cracked;
  for (std::size_t p = 0; p < rock.domain.size(); ++p) {
    const auto c = centre(rock.domain[p]);
    const auto ring = static_cast<std::size_t>(std::hypot(c[0], c[1]) / width);
    if (ring >= area_of.size()) area_of.resize(ring + 1), crushed.resize(ring + 1), cracked.resize(ring + 1);
    const double A = area(rock.domain[p]);
    area_of[ring] += A, crushed[ring] += A * rock.crushed[p], cracked[ring] += A * rock.cracked[p];
  }
  Curve a{.name = name + ", crushed"}, b{.name = name + ", cracked", .style = "lines dashtype 2 linewidth 2"};
  for (std::size_t k = 0; k < area_of.size() && (double(k) + .5) * width < 1; ++k) {
    if (area_of[k] == 0) continue;
    a.x.push_back(1e3 * (double(k) + .5) * width), a.y.push_back(crushed[k] / area_of[k]);
    b.x.push_back(1e3 * (double(k) + .5) * width), b.y.push_back(cracked[k] / area_of[k]);
  }
  axes.curves.push_back(a), axes.curves.push_back(b);
}

void draw_damage(const Blasts& blasts, double half_width, Report& report) {
  std::vector<Tile> tiles;
  Axes zones{"damage over the distance from the hole", "distance, mm", "mean over the ring", {}, {}};
  for (const auto& [title, state] : in_order()) {
    const auto& blast = blasts.at(state);
    const Rock rock = read_rock(blast);
    tiles.push_back({title, damage_picture(rock, blast.scene, half_width)});
    if (state == State{0, 0} || state == State{50, 50}) add_zones(zones, rock, title, 2 * blast.scene.rock.particle);
  }
  draw_tiles(tiles, {.quantity = "damage", .half_width = half_width, .hole = .021, .pixels = 250},
             report.folder / "fig11.png");
  draw_curves({zones}, 1, report.folder / "zones.png");
}

void draw_lengths(const States& s, Report& report) {
  const std::string marks = "linespoints linewidth 2 pointtype 7";
  Axes levels{"equal stresses",
              "in-situ stress, MPa",
              "crack length, mm",
              {{"reach", {}, {}, marks}, {"along x", {}, {}, marks}, {"along y", {}, {}, marks}},
              "set yrange [0:*]\nset key bottom left\n"};
  Axes ratios{"40 MPa along y, k times that along x",
              "k",
              "crack length, mm",
              {{"along x", {}, {}, marks}, {"along y", {}, {}, marks}},
              "set yrange [0:*]\nset key bottom left\n"};
  for (const double level : equiaxial_levels) {
    const auto& m = s.at({level, level});
    for (auto& curve : levels.curves) curve.x.push_back(level);
    levels.curves[0].y.push_back(1e3 * m.reach), levels.curves[1].y.push_back(1e3 * m.along_x),
        levels.curves[2].y.push_back(1e3 * m.along_y);
  }
  for (const double k : lateral_ratios) {
    const auto& m = s.at({k * vertical_stress, vertical_stress});
    for (auto& curve : ratios.curves) curve.x.push_back(k);
    ratios.curves[0].y.push_back(1e3 * m.along_x), ratios.curves[1].y.push_back(1e3 * m.along_y);
  }
  draw_curves({levels, ratios}, 2, report.folder / "lengths.png");
}

Curve rose_of(const Blast& blast, const std::string& name) {
  const auto rose = blast.table("rose.csv");
  Curve curve{.name = name};
  const auto &direction = rose.at("direction"), &reach = rose.at("reach");
  for (std::size_t i = 0; i <= reach.size(); ++i) {
    const double theta = direction[i % reach.size()] * std::numbers::pi / 180, r = 1e3 * reach[i % reach.size()];
    curve.x.push_back(r * std::cos(theta)), curve.y.push_back(r * std::sin(theta));
  }
  return curve;
}

void draw_roses(const Blasts& blasts, Report& report) {
  const std::string square = "set size ratio -1\nset xtics 500\nset key outside right top\n";
  Axes levels{"equal stresses", "x, mm", "y, mm", {}, square},
      ratios{"40 MPa along y, k times that along x", "x, mm", "y, mm", {}, square};
  for (const double level : equiaxial_levels)
    levels.curves.push_back(rose_of(blasts.at({level, level}), fixed(level, 0) + " MPa"));
  for (const double k : lateral_ratios)
    ratios.curves.push_back(rose_of(blasts.at({k * vertical_stress, vertical_stress}), "k = " + mpm::io::number(k)));
  draw_curves({levels, ratios}, 2, report.folder / "rose.png");
}

void draw_growth(const Blasts& blasts, Report& report) {
  Axes axes{"equal stresses", "time, us", "reach, mm", {}, "set key outside right\n"};
  for (const double level : equiaxial_levels) {
    const auto cracks = blasts.at({level, level}).table("cracks.csv");
    Curve curve{.name = fixed(level, 0) + " MPa"};
    for (const double t : cracks.at("time")) curve.x.push_back(1e6 * t);
    for (const double r : cracks.at("reach")) curve.y.push_back(1e3 * r);
    axes.curves.push_back(curve);
  }
  draw_curves({axes}, 1, report.folder / "growth.png");
}

TableOf state_table(const States& states) {
  TableOf table{{"horizontal / vertical, MPa", "reach, mm", "along x / along y, mm", "V/H", "damaged area, cm2",
                 "crushed to, mm", "longest crack, degrees from x"},
                {}};
  for (const auto& [state, m] : states)
    table.rows.push_back({fixed(state.first, 0) + " / " + fixed(state.second, 0), fixed(1e3 * m.reach, 0),
                          fixed(1e3 * m.along_x, 0) + " / " + fixed(1e3 * m.along_y, 0),
                          fixed(m.along_y / m.along_x, 2), fixed(1e4 * m.area, 0), fixed(1e3 * m.crushed, 0),
                          fixed(m.longest, 0)});
  return table;
}

/// The claims on the blasts as shown, judged on the coarse ones for every seed as well.
std::vector<Finding> findings_on(const States& shown, const Report& report) {
  auto findings = judge(shown);
  for (int seed = 1; seed <= seeds; ++seed) {
    Blasts blasts;
    for (const auto& state : all_states())
      blasts[state] = run({"coarse-" + name_of(state) + "-seed" + std::to_string(seed), coarse_quarter(state, seed)},
                          report.folder / "blasts");
    const auto of_seed = judge(measured(blasts));
    for (std::size_t i = 0; i < findings.size(); ++i) findings[i].by_seed.push_back(of_seed[i].holds);
  }
  return findings;
}

}  // namespace

void twelve_blasts(Report& report) {
  Blasts blasts;
  for (const auto& state : all_states())
    blasts[state] = run({name_of(state), scene_of(state, report.quick)}, report.folder / "blasts");
  const auto states = measured(blasts);
  double reach = 0;
  for (const auto& [state, m] : states) reach = std::max(reach, m.reach);
  draw_damage(blasts, std::min(states.begin()->second.half_side, std::ceil(10.5 * reach) / 10), report);
  draw_lengths(states, report);
  draw_roses(blasts, report);
  draw_growth(blasts, report);
  for (auto& finding : findings_on(states, report)) report.findings.push_back(std::move(finding));
  report.states = state_table(states);

  auto& page = report.page;
  page.section("Fig. 11: the twelve blasts", "fig11");
  page.figure(report.folder, "fig11.png",
              "Damage at 300 us, full planes at one scale: crushed rock red, cracks black.");
  page.table(report.states);
  page.figure(report.folder, "lengths.png", "Crack length over the in-situ stress.");
  page.figure(report.folder, "rose.png", "Crack roses: reach of the damage by direction.");
  page.figure(report.folder, "growth.png",
              "Reach over time: under high stress cracks stop, without stress they still run at the end, so their "
              "length there depends on the end time.");
  page.figure(report.folder, "zones.png", "Zones round the hole: mean damage of each kind by distance.");
}

}  // namespace paper
