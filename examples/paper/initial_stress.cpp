// SPDX-License-Identifier: MIT
#include "plot.hpp"
#include "report.hpp"
#include <blasting/stages.hpp>
#include <mpm/analysis/ring_fit.hpp>
#include <mpm/relax.hpp>
#include <problems/kirsch.hpp>

namespace paper {
namespace {

using blasting::Scene;

/// The scene's elastic rock, settled.
struct Settled {
  std::vector<blasting::Quad> domain{};
  std::vector<double> radial{}, hoop{}, radial_error{}, hoop_error{};  ///< over the larger far-field stress
  double far_error = 0;            ///< L2 of all in-plane components from 3 a on, over the same
  double wall_0 = 0, wall_90 = 0;  ///< of the hoop stress on the wall, over the same
  std::int64_t steps = 0;
};

Scene scene_of(State state, blasting::StressStart start, double cells) {
  Scene scene;
  scene.rock.law = blasting::RockLaw::elastic;
  scene.grid.cell = scene.hole.radius / cells;
  scene.rock.particle = scene.grid.cell / 2;
  scene.block.side = 40 * scene.hole.radius;
  scene.stress = {.horizontal = 1e6 * state.first, .vertical = 1e6 * state.second, .start = start};
  return scene;
}

Settled settle(const Scene& scene) {
  auto solver = blasting::relaxation_stage<blasting::Rock<blasting::ElasticRock>>(scene);
  Settled result;
  result.steps = mpm::relax(solver, {.tolerance = 1e-6}).steps;
  const auto& rock = solver.body();
  const auto exact = blasting::in_situ(scene);
  const double unit = std::max(scene.stress.horizontal, scene.stress.vertical), a = scene.hole.radius;
  for (std::size_t p = 0; p < rock.size(); ++p) {
    blasting::Quad quad;
    for (std::size_t c = 0; c < 4; ++c) quad[c] = rock.shape.corner[rock.shape.quad[p][c]];
    result.domain.push_back(quad);
    const double x = rock.x(0)[p], y = rock.x(1)[p], theta = std::atan2(y, x);
    const auto s = rock.stress(p);
    const auto polar = mpm::analysis::to_polar({s.xx, s.yy, s.xy}, theta);
    const auto kirsch = exact.polar_stress(std::hypot(x, y), theta);
    result.radial.push_back(polar.rr / unit), result.hoop.push_back(polar.tt / unit);
    result.radial_error.push_back(100 * (polar.rr - kirsch.rr) / unit);
    result.hoop_error.push_back(100 * (polar.tt - kirsch.tt) / unit);
  }
  result.far_error = mpm::problems::detail::stress_error(rock, exact, 3 * a) / unit;
  const double window = std::min(.5 * a, 2 * scene.grid.cell);
  const auto wall = mpm::analysis::fit_wall(mpm::problems::Samples(rock, 0, a + window), a, window).hoop;
  result.wall_0 = (wall.at(0) - exact.polar_stress(a, 0).tt) / unit;
  result.wall_90 = (wall.at(M_PI / 2) - exact.polar_stress(a, M_PI / 2).tt) / unit;
  return result;
}

std::string percent(double share, int digits) {
  return fixed(100 * share, digits) + " %";
}

}  // namespace

void initial_stress(Report& report) {
  const std::pair<const char*, State> cases[] = {
      {"10 MPa", {10, 10}}, {"40 MPa", {40, 40}}, {"k = .25", {10, 40}}, {"k = 3", {120, 40}}};
  const double cells = report.quick ? 4 : 8;
  std::vector<Tile> fields, errors;
  TableOf table{{"State", "start", "cells a radius", "steps", "wall at 0 / 90 degrees", "from 3 a on (L2)"}, {}};
  double worst_wall = 0, worst_far = 0;
  for (const auto& [name, state] : cases)
    for (const auto start : {blasting::StressStart::far_field, blasting::StressStart::kirsch}) {
      const auto scene = scene_of(state, start, cells);
      const auto settled = settle(scene);
      const bool far = start == blasting::StressStart::far_field;
      table.rows.push_back({name, far ? "far field" : "Kirsch", fixed(cells, 0), std::to_string(settled.steps),
                            percent(settled.wall_0, 2) + " / " + percent(settled.wall_90, 2),
                            percent(settled.far_error, 3)});
      if (!far) continue;
      worst_wall = std::max({worst_wall, std::abs(settled.wall_0), std::abs(settled.wall_90)});
      worst_far = std::max(worst_far, settled.far_error);
      blasting::Picture picture{.half_width = .105, .quarter = true};
      fields.push_back({std::string(name) + ", radial", blasting::rasterise(picture, settled.domain, settled.radial)});
      fields.push_back({std::string(name) + ", hoop", blasting::rasterise(picture, settled.domain, settled.hoop)});
      errors.push_back(
          {std::string(name) + ", radial", blasting::rasterise(picture, settled.domain, settled.radial_error)});
      errors.push_back(
          {std::string(name) + ", hoop", blasting::rasterise(picture, settled.domain, settled.hoop_error)});
    }
  TileStyle style{.quantity = "stress over the larger far-field stress",
                  .colours = blasting::ColourMap::sequential,
                  .low = -3,
                  .high = .5,
                  .half_width = .105,
                  .hole = .021};
  draw_tiles(fields, style, report.folder / "fig9.png");
  style.quantity = "error, % of the larger far-field stress", style.colours = blasting::ColourMap::diverging;
  style.low = -2, style.high = 2;
  draw_tiles(errors, style, report.folder / "fig9_error.png");
  report.findings.push_back(
      {"Fig. 9: relaxed from the far field, the rock finds Kirsch's stress: wall within 2 %, from 3 a on within .5 %",
       "worst " + percent(worst_wall, 2) + " on the wall, " + percent(worst_far, 3) + " beyond",
       worst_wall < .02 && worst_far < .005});  // the sides, 20 a off, are under the far field itself: .25 %
  report.page.section("Fig. 9: the relaxed stress", "fig9");
  report.page.figure(report.folder, "fig9.png",
                     "Elastic rock relaxed from the far field; the window is 10 radii wide.");
  report.page.figure(report.folder, "fig9_error.png", "What these differ from Kirsch's solution.");
  report.page.text(
      "Errors of the hoop stress, read by a fit to the particles near the wall, over the larger far-field stress:");
  report.page.table(table);
}

}  // namespace paper
