// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include "snapshot.hpp"
#include "states.hpp"
#include <algorithm>

namespace paper {
namespace {

using blasting::Mirror;

/// A hole and its image in the side of the block, `spacing` apart, m.
Case pair(double spacing, Mirror side) {
  auto scene = scene_of({10, 40}, true);
  scene.block.mirror = side;
  (side == Mirror::left ? scene.hole.x : scene.hole.y) = spacing / 2 - scene.block.side / 2;
  scene.output.probes = {};
  return {std::string("pair-") + (side == Mirror::left ? "across-" : "along-") + fixed(1e3 * spacing, 0), scene};
}

/// Reach of the damage from the hole towards its image, m: the farther of the three sectors about that direction.
double towards_image(const Blast& blast, Mirror side) {
  const auto rose = blast.table("rose.csv");
  const double direction = side == Mirror::left ? 180 : 270;
  double reach = 0;
  for (std::size_t k = 0; k < rose.at("reach").size(); ++k)
    if (std::abs(rose.at("direction")[k] - direction) <= 10.5) reach = std::max(reach, rose.at("reach")[k]);
  return reach;
}

}  // namespace

void hole_pairs(Report& report) {
  TableOf table{
      {"Spacing, mm", "along the larger stress: reach towards the other hole, mm", "joined", "across it", "joined"},
      {}};
  std::vector<Tile> tiles;
  double farthest[2] = {0, 0};
  for (const double spacing : {1., 1.3, 1.6}) {
    std::vector<std::string> row{fixed(1e3 * spacing, 0)};
    for (const Mirror side : {Mirror::bottom, Mirror::left}) {
      const auto blast = run(pair(spacing, side), report.folder / "blasts");
      if (!blast.completed()) throw std::runtime_error(blast.folder.string() + ": " + blast.problem);
      const double reach = towards_image(blast, side);
      const bool joined = reach >= spacing / 2 - 2 * blast.scene.rock.particle;
      if (joined) farthest[side == Mirror::left] = std::max(farthest[side == Mirror::left], spacing);
      row.push_back(fixed(1e3 * reach, 0)), row.push_back(joined ? "yes" : "no");
      if (spacing != 1.)
        tiles.push_back({(side == Mirror::left ? "across, " : "along, ") + fixed(1e3 * spacing, 0) + " mm",
                         damage_picture(read_rock(blast), blast.scene, .9)});
    }
    table.rows.push_back(row);
  }
  draw_tiles(tiles, {.quantity = "damage", .half_width = .9, .hole = .021, .pixels = 250}, report.folder / "pairs.png");
  report.findings.push_back(
      {"Section 4.3: holes set along the larger stress (k = .25) join their cracks at a larger spacing than across it",
       "up to " + fixed(1e3 * farthest[0], 0) + " mm along, " + fixed(1e3 * farthest[1], 0) +
           " mm across, of 1000, 1300, 1600",
       farthest[0] > farthest[1]});
  report.page.section("Two holes", "pairs");
  report.page.figure(report.folder, "pairs.png",
                     "Two holes fired at once, 10 MPa along x and 40 MPa along y, cells of 20 mm: one is modelled, the "
                     "other is its image in the lower or the left side of the block.");
  report.page.text("Joined: the damage towards the other hole has reached half the spacing by 300 us.");
  report.page.table(table);
}

}  // namespace paper
