// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include "snapshot.hpp"
#include "states.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>

namespace paper {
namespace {

/// The larger stress is along y.
enum class Line { along, across };

/// Two holes `spacing` apart, m; the second one fired `delay` after the first, s, and 300 us before the end.
Case pair(double spacing, Line line, double delay = 0) {
  auto scene = scene_of({10, 40}, true);
  scene.block.side = 4;
  scene.hole.x = scene.hole.y = {0, 0};
  (line == Line::across ? scene.hole.x : scene.hole.y) = {-spacing / 2, spacing / 2};
  scene.output.probes = {};
  auto name = std::string("two-") + (line == Line::across ? "across-" : "along-") + fixed(1e3 * spacing, 0);
  if (delay > 0) scene.charge.delay = {0, delay}, scene.end_time += delay, name += "-delay-" + fixed(1e6 * delay, 0);
  return {name, scene};
}

Blast completed(const Case& one, const Report& report) {
  auto blast = run(one, report.folder / "blasts");
  if (!blast.completed()) throw std::runtime_error(blast.folder.string() + ": " + blast.problem);
  return blast;
}

/// How far from each hole towards the other broken rock reaches without a gap, m: particles of damage beyond .5, each a
/// neighbour of the one before. What breaks where the two waves meet does not count before a crack has come there.
struct Bridge {
  double from_first = 0, from_second = 0;
  bool joined = false;
};

class BrokenRock {
 public:
  explicit BrokenRock(const Blast& blast) : scene_(blast.scene) {
    const Rock rock = read_rock(blast);
    for (std::size_t p = 0; p < rock.domain.size(); ++p)
      if (std::max(rock.crushed[p], rock.cracked[p]) >= .5)
        broken_[cell_of(centre(rock.domain[p]))] = centre(rock.domain[p]);
  }

  Bridge between_holes() const {
    Bridge bridge;
    bridge.from_first = reach(0, bridge.joined);
    bridge.from_second = reach(1, bridge.joined);
    return bridge;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  Cell cell_of(const blasting::Vec2& x) const {  // a lattice as fine as the particles
    return {std::llround(x[0] / scene_.rock.particle), std::llround(x[1] / scene_.rock.particle)};
  }
  bool at_hole(const blasting::Vec2& x, std::size_t k) const {
    return std::hypot(x[0] - scene_.hole.x[k], x[1] - scene_.hole.y[k]) < 3 * scene_.hole.radius;
  }
  /// From hole k on, along the line to the other; `joined` if it gets there.
  double reach(std::size_t k, bool& joined) const {
    auto left = broken_;
    std::vector<Cell> front;
    const auto visit = [&](const Cell& cell) {
      if (left.erase(cell) != 0) front.push_back(cell);
    };
    for (const auto& [cell, x] : broken_)
      if (at_hole(x, k)) visit(cell);
    const auto from = scene_.hole_centre(k), to = scene_.hole_centre(1 - k);
    const double spacing = std::hypot(to[0] - from[0], to[1] - from[1]);
    double farthest = 0;
    while (!front.empty()) {
      const auto [i, j] = front.back();
      front.pop_back();
      const auto& x = broken_.at({i, j});
      const double along = ((x[0] - from[0]) * (to[0] - from[0]) + (x[1] - from[1]) * (to[1] - from[1])) / spacing;
      farthest = std::max(farthest, std::min(along, spacing));
      joined = joined || at_hole(x, 1 - k);
      for (std::int64_t dj = -1; dj <= 1; ++dj)
        for (std::int64_t di = -1; di <= 1; ++di) visit({i + di, j + dj});
    }
    return farthest;
  }

  const blasting::Scene& scene_;
  std::map<Cell, blasting::Vec2> broken_;
};

std::string reach_text(const Bridge& bridge) {
  return bridge.joined ? "joined" : fixed(1e3 * bridge.from_first, 0) + ", " + fixed(1e3 * bridge.from_second, 0);
}

constexpr double window = 1.4;  ///< half width of the pictures, m

Tile tile(const Blast& blast, const std::string& title) {
  return {title, damage_picture(read_rock(blast), blast.scene, window), blast.scene.hole_centres()};
}

}  // namespace

void hole_pairs(Report& report) {
  TableOf table{{"Spacing, mm", "along the larger stress", "across it"}, {}};
  std::vector<Tile> tiles;
  double farthest[2] = {0, 0};
  for (const double spacing : {1.4, 1.6, 1.7, 1.8, 1.9}) {
    std::vector<std::string> row{fixed(1e3 * spacing, 0)};
    for (const Line line : {Line::along, Line::across}) {
      const auto blast = completed(pair(spacing, line), report);
      const auto bridge = BrokenRock(blast).between_holes();
      if (bridge.joined) farthest[line == Line::across] = spacing;
      row.push_back(reach_text(bridge));
      if (spacing == 1.6)
        tiles.push_back(tile(blast, (line == Line::across ? "across, " : "along, ") + row[0] + " mm"));
    }
    table.rows.push_back(row);
  }
  constexpr double spacing = 1.4;
  const auto at_once = completed(pair(spacing, Line::across), report);
  const auto delayed = completed(pair(spacing, Line::across, 150e-6), report);
  TableOf fired{{"Second hole", "reach towards the other hole, mm", "reach, mm", "damaged area, cm2"}, {}};
  for (const auto* blast : {&at_once, &delayed}) {
    const std::string when = blast == &at_once ? "at once" : "150 us later";
    tiles.push_back(tile(*blast, blast == &at_once ? "across, 1400 mm" : "the same, delayed"));
    fired.rows.push_back({when, reach_text(BrokenRock(*blast).between_holes()),
                          fixed(1e3 * blast->number("crack.reach"), 0), fixed(1e4 * blast->number("crack.area"), 0)});
  }
  draw_tiles(tiles, {.quantity = "damage", .half_width = window, .hole = .021, .pixels = 250},
             report.folder / "pairs.png");
  report.findings.push_back(
      {"Section 4.3: holes set along the larger stress (k = .25) join their cracks at a larger spacing than across it",
       "up to " + fixed(1e3 * farthest[0], 0) + " mm along, " + fixed(1e3 * farthest[1], 0) +
           " mm across, of 1400, 1600, 1700, 1800, 1900",
       farthest[0] > farthest[1]});
  auto& page = report.page;
  page.section("Two holes", "pairs");
  page.figure(
      report.folder, "pairs.png",
      "Two holes, 10 MPa along x and 40 MPa along y, cells of 20 mm, 300 us after the last is fired. Delayed: the "
      "hole on the right by 150 us.");
  page.text(
      "Fired at once: how far from each hole towards the other broken rock (damage beyond .5) hangs together, mm.");
  page.table(table);
  page.text("Across the larger stress, 1400 mm apart, 300 us after the second is fired:");
  page.table(fired);
}

}  // namespace paper
