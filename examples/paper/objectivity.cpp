// SPDX-License-Identifier: MIT
#include "report.hpp"
#include "snapshot.hpp"
#include "states.hpp"
#include <blasting/laws.hpp>
#include <mpm/analysis/crack_measures.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace paper {
namespace {

/// A quarter under 20 MPa on cells of this size, m.
Blast blast(Report& report, double cell, blasting::TensileLaw law) {
  auto scene = coarse_quarter({20, 20}, 1);
  scene.grid.cell = cell, scene.rock.particle = cell / 2;
  scene.rock.tensile.law = law;
  const bool rankine = law == blasting::TensileLaw::rankine;
  return run({"mesh-" + fixed(1e3 * cell, 0) + (rankine ? "" : "-jh2-alone"), scene}, report.folder / "blasts");
}

std::string change(double finer, double coarser) {
  return fixed(100 * (finer / coarser - 1), 0) + " %";
}

/// Mean reach of the sectors of the rose that lie `degrees` or less from the axes of the grid, and of the others, m.
std::pair<double, double> by_direction(const Blast& blast, double degrees) {
  const auto rose = blast.table("rose.csv");
  double sum[2] = {0, 0}, count[2] = {0, 0};
  for (std::size_t k = 0; k < rose.at("reach").size(); ++k) {
    const double off = std::fmod(rose.at("direction")[k], 90);
    const int other = std::min(off, 90 - off) > degrees;
    sum[other] += rose.at("reach")[k], count[other] += 1;
  }
  return {sum[0] / count[0], sum[1] / count[1]};
}

/// Extent of the damage with the stresses along the axes: as if the rock were turned back by their direction.
mpm::analysis::CrackMeasures turned_back(const Blast& blast) {
  const Rock rock = read_rock(blast);
  const double angle = blast.scene.stress.direction * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  std::vector<double> x, y, areas, damage;
  for (std::size_t p = 0; p < rock.domain.size(); ++p) {
    const auto at = centre(rock.domain[p]);
    x.push_back(c * at[0] + s * at[1]), y.push_back(c * at[1] - s * at[0]);
    areas.push_back(area(rock.domain[p])), damage.push_back(std::max(rock.crushed[p], rock.cracked[p]));
  }
  return mpm::analysis::crack_measures({.x = x, .y = y, .area = areas, .damage = damage, .crushing = rock.crushed},
                                       {.ring_width = blast.scene.rock.particle});
}

/// 10 and 40 MPa along the grid, and turned against it.
void turn_stresses(Report& report) {
  constexpr double degrees = 30;
  auto scene = scene_of({10, 40}, report.quick);
  const auto along = turned_back(run({name_of({10, 40}), scene}, report.folder / "blasts"));
  scene.stress.direction = degrees;
  const auto turned = turned_back(run({name_of({10, 40}) + "-turned", scene}, report.folder / "blasts"));
  const double reach = turned.reach / along.reach, larger = turned.along_y / along.along_y,
               smaller = turned.along_x / along.along_x;
  const auto change_of = [](double ratio) { return fixed(100 * (ratio - 1), 1) + " %"; };
  report.findings.push_back(
      {"Under 10 and 40 MPa turned by 30 degrees against the grid the reach changes by at most 10 %, and so do the "
       "extents along the larger and the smaller stress",
       "reach " + change_of(reach) + ", along the larger " + change_of(larger) + ", the smaller " + change_of(smaller),
       std::max({std::abs(reach - 1), std::abs(larger - 1), std::abs(smaller - 1)}) <= .1});
}

}  // namespace

void objectivity(Report& report) {
  TableOf table{{"Rock", "cell, mm", "reach, mm", "damaged area, cm2", "energy spent in opening cracks, kJ/m"}, {}};
  for (const auto law : {blasting::TensileLaw::rankine, blasting::TensileLaw::none}) {
    const bool rankine = law == blasting::TensileLaw::rankine;
    double reach = 0, energy = 0;
    for (const double cell : {.02, .01, .005}) {
      if (cell < .01 && (report.quick || !rankine)) continue;
      const auto one = blast(report, cell, law);
      const double finer_reach = one.number("crack.reach"),
                   finer_energy = one.table("ledger.csv").at("fracture").back();
      const std::string size = fixed(1e3 * cell, 0);
      table.rows.push_back({rankine ? "JH-2 with the tensile law, 500 J/m2" : "JH-2 alone", size,
                            fixed(1e3 * finer_reach, 0), fixed(1e4 * one.number("crack.area"), 0),
                            rankine ? fixed(1e-3 * finer_energy, 1) : "no such law"});
      if (rankine && reach > 0)
        report.findings.push_back(
            {"From cells of " + fixed(2e3 * cell, 0) + " mm to " + size +
                 " mm the reach changes by at most 10 %, the energy spent in opening cracks by at most 15 %",
             "reach " + change(finer_reach, reach) + ", energy " + change(finer_energy, energy),
             std::abs(finer_reach / reach - 1) <= .1 && std::abs(finer_energy / energy - 1) <= .15});
      reach = finer_reach, energy = finer_energy;
    }
  }

  blasting::Scene brittle;  // too little energy to localise on its particles
  brittle.rock.tensile.fracture_energy = 100;
  std::string refusal;
  try {
    blasting::check_laws(brittle);
  } catch (const mpm::io::InputError& error) {
    refusal = error.what();
  }
  table.rows.push_back(
      {"JH-2 with the tensile law, 100 J/m2", fixed(1e3 * brittle.grid.cell, 0), "", "", "refused: " + refusal});

  double least = 1e9, most = 0;
  for (const double level : equiaxial_levels) {
    const auto [near, off] = by_direction(
        run({name_of({level, level}), scene_of({level, level}, report.quick)}, report.folder / "blasts"), 15);
    least = std::min(least, near / off), most = std::max(most, near / off);
  }
  report.findings.push_back(
      {"Under equal stresses cracks reach as far along the grid's lines (within 15 degrees) as between them: within 10 "
       "%",
       "ratio " + fixed(least, 2) + " to " + fixed(most, 2) + " over the six levels", least >= .9 && most <= 1.1});
  turn_stresses(report);
  report.page.section("Cracks and mesh", "mesh");
  report.page.text("A quarter under 20 MPa on meshes of several sizes:");
  report.page.table(table);
}

}  // namespace paper
