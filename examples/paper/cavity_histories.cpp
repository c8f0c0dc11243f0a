// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include <mpm/materials/presets.hpp>
#include <problems/cavity.hpp>
#include <algorithm>

namespace paper {
namespace {

using mpm::analysis::BlastCavity;
using mpm::problems::hole;

constexpr std::array radii{1.0, 2.0, 5.0, 10.0};  // over the hole's
constexpr double end = 80e-6;                     // s; what the faces send back has not yet come

/// Stresses at the radii over time, Pa.
struct History {
  std::vector<double> time{};
  std::array<std::vector<double>, radii.size()> radial{}, hoop{};
};

/// Rock under the pulse on the particle edges that make the wall.
template <class Rock>
History simulate(const Rock& law, const mpm::analysis::BlairLoad& load, double cells) {
  constexpr double side = 15;
  using Space = mpm::PlaneStrain<>;
  mpm::Solver<mpm::CpdiQuad, Rock, mpm::Fmpm, Space> solver(
      mpm::problems::holed_block_grid<Space>(side, cells),
      mpm::geometry::make_body<Space>("rock", mpm::problems::holed_block(side, cells).mesh(), law));
  solver.integrator = {.order = 4};
  mpm::problems::roll_on_axes(solver);
  History history;
  const double cell = hole / cells, window = std::min(.5 * hole, 2 * cell);
  while (solver.time < end) {
    solver.body().shape.pressure = load.pressure(solver.time);
    solver.step(std::min(5e-7, end - solver.time));
    history.time.push_back(solver.time);
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const double r = radii[i] * hole;
      if (radii[i] == 1) {
        const auto wall = mpm::analysis::fit_wall(mpm::problems::Samples(solver.body(), 0, r + window), r, window);
        history.radial[i].push_back(wall.radial.mean), history.hoop[i].push_back(wall.hoop.mean);
      } else {
        const auto ring = mpm::analysis::fit_ring(mpm::problems::Samples(solver.body(), r - cell, r + cell), r, cell);
        history.radial[i].push_back(ring.rr), history.hoop[i].push_back(ring.tt);
      }
    }
  }
  return history;
}

History exact(const BlastCavity& cavity) {
  History history;
  for (double t = 2.5e-7; t <= end; t += 2.5e-7) history.time.push_back(t);
  for (std::size_t i = 0; i < radii.size(); ++i)
    for (const auto& state : cavity.history(radii[i] * hole, history.time))
      history.radial[i].push_back(state.rr), history.hoop[i].push_back(state.tt);
  return history;
}

std::vector<double> scaled(std::vector<double> values, double by) {
  for (double& value : values) value *= by;
  return values;
}
double peak(const std::vector<double>& values) {
  return *std::ranges::max_element(values, {}, [](double v) { return std::abs(v); });
}

Curve curve(const std::string& name, const History& history, const std::vector<double>& stress,
            const std::string& style) {
  return {name, scaled(history.time, 1e6), scaled(stress, 1e-6), style};
}

}  // namespace

void cavity_histories(Report& report) {
  auto cavity = mpm::problems::blast_cavity();
  cavity.load.peak = 100e6;
  const double cells = report.quick ? 4 : 8;
  const auto theory = exact(cavity), elastic = simulate(mpm::granite_elastic(), cavity.load, cells),
             rock = simulate(mpm::granite_paper(), cavity.load, cells);
  const std::string time = "time, us";
  Axes pulse{"(a) pressure on the wall", time, "pressure, MPa", {{"", {}, {}}}, {}};
  for (double t = 0; t <= end; t += 5e-7)
    pulse.curves[0].x.push_back(t * 1e6), pulse.curves[0].y.push_back(cavity.load.pressure(t) * 1e-6);
  Axes radial{"(b) radial stress, exact", time, "stress, MPa", {}, "set key bottom right\n"},
      hoop{"(c) hoop stress, exact", time, "stress, MPa", {}, {}};
  std::vector<Axes> panels{pulse, radial, hoop};
  TableOf table{{"Radius", "peak", "exact, MPa", "elastic rock", "JH-2 with the tensile law"}, {}};
  double worst = 0;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const std::string at = "r = " + fixed(radii[i], 0) + " a";
    panels[1].curves.push_back(curve(at, theory, theory.radial[i], "lines linewidth 2"));
    panels[2].curves.push_back(curve(at, theory, theory.hoop[i], "lines linewidth 2"));
    for (const auto component : {&History::radial, &History::hoop}) {
      const bool is_hoop = component == &History::hoop;
      const double of = peak((theory.*component)[i]), e = peak((elastic.*component)[i]), j = peak((rock.*component)[i]);
      table.rows.push_back({at, is_hoop ? "hoop" : "radial", fixed(of * 1e-6, 2), fixed(100 * (e / of - 1), 2) + " %",
                            fixed(100 * (j / of - 1), 1) + " %"});
      if (radii[i] == 1 && !is_hoop) continue;  // it is the load
      worst = std::max(worst, std::abs(e / of - 1));
      if (radii[i] == 10) continue;
      panels.push_back({"(d) " + std::string(is_hoop ? "hoop" : "radial") + " stress, " + at,
                        time,
                        "stress, MPa",
                        {curve("exact", theory, (theory.*component)[i], "lines linewidth 2 linecolor rgb '#000000'"),
                         curve("elastic rock", elastic, (elastic.*component)[i],
                               "lines dashtype 2 linewidth 3 linecolor rgb '#D55E00'"),
                         curve("JH-2 rock", rock, (rock.*component)[i], "lines linewidth 2 linecolor rgb '#0072B2'")},
                        is_hoop ? "set offsets 0, 0, graph .4, 0\nset key top right\n"
                                : "set offsets 0, 0, 0, graph .4\nset key bottom right\n"});
    }
  }
  draw_curves(panels, 2, report.folder / "fig10.png");
  const double bar = report.quick ? .02 : .01;
  report.findings.push_back(
      {"Fig. 10: elastic rock follows the theory, all peaks from the wall to 10 a within " + fixed(100 * bar, 0) + " %",
       "worst " + fixed(100 * worst, 2) + " %", worst < bar});
  report.page.section("Fig. 10: the wave from the hole", "fig10");
  report.page.figure(report.folder, "fig10.png",
                     "Blair's pulse (100 MPa, n = 2, gamma = 1e5/s) on the wall of the 21 mm hole, " + fixed(cells, 0) +
                         " cells a radius; FMPM(4). JH-2 rock departs from the theory since its "
                         "pressure is not linear in the volume and "
                         "since it cracks where the hoop stress reaches its tensile strength of 54 MPa.");
  report.page.table(table);
}

}  // namespace paper
