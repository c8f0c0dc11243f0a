// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include "snapshot.hpp"
#include <cmath>
#include <stdexcept>

namespace paper {
namespace {

/// Jung et al.'s slab, as Xiao et al. 2024, section 3.5, give it: sides, hole, density, E, nu, tensile strength and
/// prestress. The rest is assumed, see `assumptions`.
Case slab(double prestress, int seed) {
  blasting::Scene scene;
  scene.model = blasting::Model::full;
  scene.hole.radius = 4e-3;
  scene.charge.radius = .3e-3;
  scene.block.side = .2, scene.block.faces = blasting::Faces::free;
  scene.grid.cell = 2e-3, scene.rock.particle = 1e-3;
  scene.gas.particles_per_edge = 16;
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

constexpr const char* assumptions =
    "Given: 200 mm square, hole of 4 mm radius, 2625 kg/m3, 20.7 GPa, .12, tensile strength 6.2 MPa, 5 MPa along x. "
    "Assumed: plane strain, sides free under their load; the paper's dimensionless JH-2 constants with "
    "sigma_HEL 440 MPa and P_HEL 366 MPa (an unconfined strength of 70 MPa), K1 from E and nu, a fracture energy of 40 "
    "J/m2, Weibull modulus 6; a PETN charge of .3 mm radius, 2 kJ a metre: what an open slab of 23 mm vents cannot be "
    "modelled in plane strain, so the charge is chosen to make cracks of a few centimetres. Pattern and direction "
    "can be compared, lengths not.";

/// What the damage round the hole measures, without the spall that the free sides make beyond 60 mm.
struct Extent {
  double x = 0, y = 0;  ///< root of the mean square of the damaged area's distances, m
};
Extent extent(const Rock& rock) {
  constexpr double within = .06;
  double sum = 0;
  Extent e;
  for (std::size_t p = 0; p < rock.domain.size(); ++p) {
    const auto c = centre(rock.domain[p]);
    if (std::max(rock.crushed[p], rock.cracked[p]) <= .5 || std::hypot(c[0], c[1]) > within) continue;
    const double A = area(rock.domain[p]);
    sum += A, e.x += A * c[0] * c[0], e.y += A * c[1] * c[1];
  }
  return {std::sqrt(e.x / sum), std::sqrt(e.y / sum)};
}

}  // namespace

void marble_slab(Report& report) {
  std::vector<Tile> tiles;
  TableOf table{{"Prestress along x", "seed", "extent along x / along y, mm", "ratio"}, {}};
  std::string ratios;
  bool holds = true;
  for (const double prestress : {0., 5e6})
    for (const int seed : {1, 2, 3}) {
      const auto blast = run(slab(prestress, seed), report.folder / "blasts");
      if (!blast.completed()) throw std::runtime_error(blast.folder.string() + ": " + blast.problem);
      const auto rock = read_rock(blast);
      const auto [x, y] = extent(rock);
      const std::string name = fixed(prestress * 1e-6, 0) + " MPa";
      table.rows.push_back(
          {name, std::to_string(seed), fixed(1e3 * x, 1) + " / " + fixed(1e3 * y, 1), fixed(x / y, 2)});
      ratios += (ratios.empty() ? "" : ", ") + fixed(x / y, 2);
      holds = holds && (prestress > 0 ? x / y >= 1.25 : std::abs(x / y - 1) <= .15);
      if (seed == 1) tiles.push_back({name, damage_picture(rock, blast.scene, .1)});
    }
  draw_tiles(tiles, {.quantity = "damage", .half_width = .1, .hole = 4e-3, .columns = 2, .pixels = 500},
             report.folder / "fig6.png");
  report.findings.push_back(
      {"Fig. 6: cracks in marble spread all round without prestress (extents within 15 %), along "
       "it under 5 MPa (x/y at least 1.25), three seeds each",
       "x/y " + ratios, holds});
  report.page.section("Figs. 5 and 6: a slab of marble", "fig6");
  report.page.figure(report.folder, "fig6.png",
                     "Damage 60 us after the charge, seed 1: no prestress, and 5 MPa along x. "
                     "What lies along the sides is spall.");
  report.page.text(assumptions);
  report.page.text("Extents are root mean squares of the damaged area within 60 mm of the hole.");
  report.page.table(table);
}

}  // namespace paper
