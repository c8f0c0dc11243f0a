// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include "snapshot.hpp"
#include "states.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

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

/// How far from the hole towards its image broken rock reaches without a gap, m: particles of damage beyond .5, each a
/// neighbour of the one before. What breaks where the two waves meet does not count before a crack has come there.
double towards_image(const Blast& blast, Mirror side) {
  const Rock rock = read_rock(blast);
  const auto& scene = blast.scene;
  using Cell = std::pair<std::int64_t, std::int64_t>;
  const auto cell_of = [&](const blasting::Vec2& x) -> Cell {  // a lattice as fine as the particles
    return {std::llround(x[0] / scene.rock.particle), std::llround(x[1] / scene.rock.particle)};
  };
  std::map<Cell, bool> reached;  // broken cells, and whether they have been
  std::vector<Cell> front;
  for (std::size_t p = 0; p < rock.domain.size(); ++p) {
    if (std::max(rock.crushed[p], rock.cracked[p]) < .5) continue;
    const auto x = centre(rock.domain[p]);
    const bool at_hole = std::hypot(x[0] - scene.hole.x, x[1] - scene.hole.y) < 3 * scene.hole.radius;
    if (reached.emplace(cell_of(x), at_hole).second && at_hole) front.push_back(cell_of(x));
  }
  const std::size_t axis = side == Mirror::left ? 0 : 1;
  const double hole = axis == 0 ? scene.hole.x : scene.hole.y;
  double reach = 0;
  while (!front.empty()) {
    const auto [i, j] = front.back();
    front.pop_back();
    reach = std::max(reach, hole - double(axis == 0 ? i : j) * scene.rock.particle);
    for (std::int64_t dj = -1; dj <= 1; ++dj)
      for (std::int64_t di = -1; di <= 1; ++di) {
        const auto next = reached.find({i + di, j + dj});
        if (next == reached.end() || next->second) continue;
        next->second = true;
        front.push_back(next->first);
      }
  }
  return reach;
}

}  // namespace

void hole_pairs(Report& report) {
  TableOf table{
      {"Spacing, mm", "along the larger stress: reach towards the other hole, mm", "joined", "across it", "joined"},
      {}};
  std::vector<Tile> tiles;
  double farthest[2] = {0, 0};
  for (const double spacing : {1.4, 1.6, 1.7, 1.8, 1.9}) {
    std::vector<std::string> row{fixed(1e3 * spacing, 0)};
    for (const Mirror side : {Mirror::bottom, Mirror::left}) {
      const auto blast = run(pair(spacing, side), report.folder / "blasts");
      if (!blast.completed()) throw std::runtime_error(blast.folder.string() + ": " + blast.problem);
      const double reach = towards_image(blast, side);
      const bool joined = reach >= spacing / 2 - 2 * blast.scene.rock.particle;
      if (joined) farthest[side == Mirror::left] = std::max(farthest[side == Mirror::left], spacing);
      row.push_back(fixed(1e3 * reach, 0)), row.push_back(joined ? "yes" : "no");
      if (spacing == 1.6 || spacing == 1.8)
        tiles.push_back({(side == Mirror::left ? "across, " : "along, ") + fixed(1e3 * spacing, 0) + " mm",
                         damage_picture(read_rock(blast), blast.scene, .9)});
    }
    table.rows.push_back(row);
  }
  draw_tiles(tiles, {.quantity = "damage", .half_width = .9, .hole = .021, .pixels = 250}, report.folder / "pairs.png");
  report.findings.push_back(
      {"Section 4.3: holes set along the larger stress (k = .25) join their cracks at a larger spacing than across it",
       "up to " + fixed(1e3 * farthest[0], 0) + " mm along, " + fixed(1e3 * farthest[1], 0) +
           " mm across, of 1400, 1600, 1700, 1800, 1900",
       farthest[0] > farthest[1]});
  report.page.section("Two holes", "pairs");
  report.page.figure(report.folder, "pairs.png",
                     "Two holes fired at once, 10 MPa along x and 40 MPa along y, cells of 20 mm: one is modelled, the "
                     "other is its image in the lower or the left side of the block.");
  report.page.text(
      "Reach: of broken rock (damage beyond .5) that hangs together from the hole on. Joined: it has come half way by "
      "300 us.");
  report.page.table(table);
}

}  // namespace paper
