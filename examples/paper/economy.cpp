// SPDX-License-Identifier: MIT
#include "report.hpp"
#include "states.hpp"
#include <functional>

namespace paper {
namespace {

struct Variant {
  const char *name, *text;
  std::function<void(blasting::Scene&)> change;
};

const std::vector<Variant>& variants() {
  using blasting::Scene;
  static const std::vector<Variant> all{
      {"full", "the full plane", [](Scene& s) { s.model = blasting::Model::full; }},
      {"no-air", "no air", [](Scene& s) { s.air.fill = false; }},
      {"gas-20", "20 gas particles an edge, as the paper", [](Scene& s) { s.gas.particles_per_edge = 20; }},
      {"seed-2", "another seed", [](Scene& s) { s.seed = 2; }},
      {"gas-2", "2 gas particles an edge", [](Scene& s) { s.gas.particles_per_edge = 2; }},
      {"side-4", "block of 4 m", [](Scene& s) { s.block.side = 4; }},
      {"side-3", "block of 3 m", [](Scene& s) { s.block.side = 3; }},
      {"side-1.8", "block of 1.8 m", [](Scene& s) { s.block.side = 1.8; }},
      {"seed-3", "another seed", [](Scene& s) { s.seed = 3; }},
      {"programmed", "burn lit from the axis", [](Scene& s) { s.charge.burn = blasting::Burn::programmed; }},
      {"far-field", "relaxed from the far field", [](Scene& s) { s.stress.start = blasting::StressStart::far_field; }},
      {"tolerance", "relaxed to 1e-4 only", [](Scene& s) { s.relaxation.tolerance = 1e-4; }},
      {"rest-off", "rock at rest worked on too", [](Scene& s) { s.step.rest_speed = 0; }},
      {"usl", "stress updated last", [](Scene& s) { s.step.update = blasting::StressUpdate::usl; }},
      {"ugimp", "rock of squares: uGIMP", [](Scene& s) { s.rock.shape = blasting::RockShape::ugimp; }},
      {"double", "the blast in double", [](Scene& s) { s.step.precision = blasting::Precision::double_; }},
      {"seed-4", "another seed", [](Scene& s) { s.seed = 4; }},
  };
  return all;
}

std::string change(double value, double from) {
  return (value < from ? "" : "+") + fixed(100 * (value / from - 1), 1) + " %";
}

}  // namespace

void economy(Report& report) {
  const auto base = coarse_quarter({20, 20}, 1);
  const auto standard = run({"economy-default", base}, report.folder / "blasts");
  const double reach = standard.number("crack.reach"), area = standard.number("crack.area");
  std::vector<std::pair<std::string, Blast>> runs;
  double cost = standard.number("cpu_seconds");  // mean of those that do the same work, begun at different times
  int alike = 1;
  for (const auto& variant : variants()) {
    auto scene = base;
    variant.change(scene);
    runs.push_back({variant.text, run({std::string("economy-") + variant.name, scene}, report.folder / "blasts")});
    if (scene.seed != base.seed) cost += runs.back().second.number("cpu_seconds"), ++alike;
  }
  cost /= alike;
  TableOf table{{"Instead of the default", "reach, mm", "change", "change of the area", "cost over the default's"},
                {{"the default: a quarter, air, 4 gas particles an edge, block of 2.4 m, all products at once, in "
                  "float, relaxed from Kirsch's field to 1e-6",
                  fixed(1e3 * reach, 0), "", "", "1 (" + fixed(cost, 1) + " core-seconds)"}}};
  for (const auto& [text, blast] : runs) {
    const double r = blast.number("crack.reach");
    table.rows.push_back({text, fixed(1e3 * r, 0), change(r, reach), change(blast.number("crack.area"), area),
                          fixed(blast.number("cpu_seconds") / cost, 2)});
  }
  report.page.section("No more than the scene needs", "economy");
  report.page.text(
      "What each part of the scene changes and costs, one at a time: 20 MPa, quarter of the plane, cells of 20 mm. "
      "Another seed of the rock's scatter is the measure of what a change means.");
  report.page.table(table);

  TableOf blocks{{"Side of the block at 0 MPa, where cracks are longest", "reach, mm", "change", "change of the area"},
                 {}};
  const auto block_of = [&](double side) {
    auto scene = scene_of({0, 0}, report.quick);
    scene.model = blasting::Model::quarter;
    scene.block.side = side;
    return run({"free-side-" + fixed(side, 1), scene}, report.folder / "blasts");
  };
  const auto largest = block_of(4);
  for (const double side : {4., 3., 2.4, 1.8}) {
    const auto blast = block_of(side);
    const double r = blast.number("crack.reach");
    blocks.rows.push_back({fixed(side, 1) + " m", fixed(1e3 * r, 0), change(r, largest.number("crack.reach")),
                           change(blast.number("crack.area"), largest.number("crack.area"))});
  }
  report.page.text("Cells are those of the blasts above.");
  report.page.table(blocks);
}

}  // namespace paper
