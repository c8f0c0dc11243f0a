// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include "states.hpp"
#include <mpm/analysis/blair_fit.hpp>
#include <algorithm>

namespace paper {
namespace {

Axes shares(const Blast& blast, const std::string& title) {
  const auto ledger = blast.table("ledger.csv");
  const double charge = blast.number("energy.charge");
  Axes axes{title, "time, us", "% of the charge's energy", {}, "set key outside right\n"};
  const std::pair<const char*, const char*> parts[] = {{"charge", "left in the products"},
                                                       {"kinetic", "kinetic"},
                                                       {"elastic", "elastic in the rock"},
                                                       {"crushing", "crushing"},
                                                       {"viscosity", "viscosity"},
                                                       {"fracture", "opening cracks"},
                                                       {"boundary", "gone through the sides"},
                                                       {"loss", "missing"}};
  for (const auto& [column, text] : parts) {
    Curve curve{.name = text};
    if (std::string(column) == "loss") curve.style = "lines dashtype 2 linewidth 2";  // there are seven colours
    for (const double t : ledger.at("time")) curve.x.push_back(1e6 * t);
    for (const double e : ledger.at(column)) curve.y.push_back(100 * e / charge);
    axes.curves.push_back(curve);
  }
  return axes;
}

void wall_pressure(const Blast& blast, Report& report) {
  constexpr double until = 100e-6;
  const auto probes = blast.table("probes.csv");
  const auto& stress = probes.at("wall_radial_stress");
  std::vector<double> time, pressure;
  for (std::size_t i = 0; i < stress.size() && probes.at("time")[i] <= until; ++i)
    time.push_back(probes.at("time")[i]), pressure.push_back(stress[0] - stress[i]);
  const auto fit = mpm::analysis::fit_blair(time, pressure);
  Axes axes{"pressure on the wall, no in-situ stress",
            "time, us",
            "pressure, MPa",
            {{"blast", {}, {}}, {"Blair's form", {}, {}}},
            {}};
  double squares = 0, total = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    for (auto& curve : axes.curves) curve.x.push_back(1e6 * time[i]);
    axes.curves[0].y.push_back(1e-6 * pressure[i]), axes.curves[1].y.push_back(1e-6 * fit.pressure(time[i]));
    squares += std::pow(pressure[i] - fit.pressure(time[i]), 2), total += pressure[i] * pressure[i];
  }
  draw_curves({axes}, 1, report.folder / "wall_pressure.png");
  report.page.figure(report.folder, "wall_pressure.png",
                     "Mean radial stress of the rock within a cell of the wall, and Blair's form (Eq 13, its exponent "
                     "corrected) through its first peak, the nearest over 100 us: P_VN = " +
                         fixed(1e-9 * fit.peak, 2) + " GPa, n = " + fixed(fit.n, 2) + ", gamma = " +
                         fixed(fit.gamma, 0) + " /s. It misses " + fixed(100 * std::sqrt(squares / total), 0) +
                         " % (root mean square): the products ring in the hole, which one pulse cannot follow.");
}

}  // namespace

void energy_ledger(Report& report) {
  std::vector<Axes> panels;
  double worst = 0;
  for (const auto& state : all_states()) {
    const auto blast = run({name_of(state), scene_of(state, report.quick)}, report.folder / "blasts");
    worst = std::max(worst, blast.number("energy.largest_loss") / blast.number("energy.charge"));
    if (state == State{0, 0}) panels.push_back(shares(blast, "no in-situ stress"));
    if (state == State{50, 50}) panels.push_back(shares(blast, "50 MPa"));
  }
  draw_curves(panels, 1, report.folder / "energy.png");
  report.findings.push_back({"The energy ledger closes to 1 % of the charge's energy at every output of every blast",
                             "worst " + fixed(100 * worst, 2) + " %", worst <= .01});
  report.page.section("Energy and wall pressure", "energy");
  report.page.figure(report.folder, "energy.png", "Where the charge's energy is.");
  wall_pressure(run({name_of({0, 0}), scene_of({0, 0}, report.quick)}, report.folder / "blasts"), report);
}

}  // namespace paper
