// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include "snapshot.hpp"

namespace paper {
namespace {

/// Jung et al.'s slab, as Xiao et al. 2024, section 3.5, give it; what they do not give is assumed and said so below.
Case slab(double prestress, bool quick, int seed) {
  blasting::Scene scene;
  scene.model = blasting::Model::full;
  scene.hole.radius = 4e-3;
  scene.charge.radius = 1e-3;
  scene.block = {.side = .2, .faces = blasting::Faces::free};
  scene.grid.cell = quick ? 2e-3 : 1e-3;
  scene.rock.particle = scene.grid.cell / 2;
  auto& r = scene.rock;
  r.density = 2625, r.young = 20.7e9, r.poisson = .12;
  r.K1 = 20.7e9 / (3 * (1 - 2 * .12)), r.K2 = 0, r.K3 = 0;
  r.sigma_hel = 440e6, r.p_hel = 366e6;
  r.tensile_pressure = 6.2e6;
  r.tensile = {.strength = 6.2e6, .fracture_energy = 40, .weibull_modulus = 6};
  scene.seed = seed;
  scene.stress.horizontal = prestress, scene.stress.vertical = 0;
  scene.end_time = 60e-6;
  scene.output = {.snapshots = 0, .probes = {}};
  return {"marble-" + fixed(prestress * 1e-6, 0) + "MPa-seed" + std::to_string(seed), scene};
}

}  // namespace

void marble_slab(Report& report) {
  std::vector<Tile> tiles;
  TableOf table{{"Prestress along x", "seed", "reach, mm", "along x / along y, mm", "ratio"}, {}};
  std::string ratios;
  bool holds = true;
  for (const double prestress : {0., 5e6})
    for (const int seed : {1, 2, 3}) {
      const auto blast = run(slab(prestress, report.quick, seed), report.folder / "blasts");
      const double x = blast.number("crack.along_x"), y = blast.number("crack.along_y");
      const std::string name = fixed(prestress * 1e-6, 0) + " MPa";
      table.rows.push_back({name, std::to_string(seed), fixed(1e3 * blast.number("crack.reach"), 1),
                            fixed(1e3 * x, 1) + " / " + fixed(1e3 * y, 1), fixed(x / y, 2)});
      ratios += (ratios.empty() ? "" : ", ") + fixed(x / y, 2);
      holds = holds && (prestress > 0 ? x / y >= 1.25 : std::abs(x / y - 1) <= .25);
      if (blast.completed() && seed == 1) tiles.push_back({name, damage_picture(read_rock(blast), blast.scene, .1)});
    }
  draw_tiles(tiles, {.quantity = "damage", .half_width = .1, .hole = 4e-3, .columns = 2, .pixels = 500},
             report.folder / "fig6.png");
  report.findings.push_back(
      {"Fig. 6: cracks in marble run all round without prestress (x/y within 25 % of 1), along it under 5 MPa (x/y at "
       "least 1.25), three seeds",
       "x/y " + ratios, holds});
  report.page.section("Figs. 5 and 6: a slab of marble", "fig6");
  report.page.figure(report.folder, "fig6.png",
                     "Damage 60 us after the charge, seed 1: no prestress, and 5 MPa along x.");
  report.page.table(table);
}

}  // namespace paper
