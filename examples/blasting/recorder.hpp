// SPDX-License-Identifier: MIT
#pragma once
#include "energy_accounts.hpp"
#include "laws.hpp"
#include "pictures.hpp"
#include "scene.hpp"
#include "stages.hpp"
#include "summary.hpp"
#include <mpm/analysis/crack_rose.hpp>
#include <mpm/analysis/polar.hpp>
#include <mpm/io/csv.hpp>
#include <mpm/io/snapshot.hpp>
#include <filesystem>
#include <string>
#include <vector>

// What a run writes: snapshots, tables, pictures, and the figures of its summary.
namespace blasting {

/// Radial and hoop stress of particle p about the nearest hole's centre, Pa.
template <class Body>
mpm::analysis::PolarStress polar_stress(const Body& body, std::size_t p, const Scene& scene) {
  const auto s = body.stress(p);
  const double x = body.x(0)[p], y = body.x(1)[p];
  const auto [hole_x, hole_y] = scene.hole_centre(scene.nearest_hole(x, y));
  const double theta = std::atan2(y - hole_y, x - hole_x);
  return mpm::analysis::to_polar({s.xx, s.yy, s.xy}, theta);
}

/// Appends a body's particles as cells, quadrilaterals where they have corners, with all their fields.
template <class Body>
void append_cells(mpm::io::UnstructuredGrid& grid, const Body& body, int number, const Scene& scene) {
  const std::int64_t first = static_cast<std::int64_t>(grid.points.size() / 3);
  if constexpr (requires { body.shape.corner; })
    for (const auto& x : body.shape.corner) grid.points.insert(grid.points.end(), {x[0], x[1], 0});
  for (std::size_t p = 0; p < body.size(); ++p) {
    if constexpr (requires { body.shape.quad; }) {
      for (const auto c : body.shape.quad[p]) grid.connectivity.push_back(first + c);
      grid.types.push_back(static_cast<std::uint8_t>(mpm::io::CellType::quad));
    } else {
      grid.points.insert(grid.points.end(), {body.x(0)[p], body.x(1)[p], 0});
      grid.connectivity.push_back(first + static_cast<std::int64_t>(p));
      grid.types.push_back(static_cast<std::uint8_t>(mpm::io::CellType::vertex));
    }
    grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
    const auto s = body.stress(p);
    const auto polar = polar_stress(body, p, scene);
    const auto damage = damage_of(body.state(p));
    const auto put = [&](std::size_t k, std::initializer_list<double> values) {
      for (const double v : values) grid.fields[k].values.push_back(static_cast<float>(v));
    };
    put(0, {double(number)});
    put(1, {-trace(s) / 3});
    put(2, {polar.rr});
    put(3, {polar.tt});
    put(4, {damage.larger()});
    put(5, {damage.crushed});
    put(6, {damage.cracked});
    put(7, {body.mass()[p] / body.volume()[p]});
    put(8, {body.v(0)[p], body.v(1)[p], 0});
    put(9, {s.xx, s.xy, s.zx, s.xy, s.yy, s.yz, s.zx, s.yz, s.zz});
  }
}

/// Everything a solver holds, for ParaView: stresses in Pa, tension positive; pressure, Pa, compression positive.
template <class Solver>
mpm::io::UnstructuredGrid snapshot_of(Solver& solver, const Scene& scene) {
  mpm::io::UnstructuredGrid grid;
  for (const char* name :
       {"body", "pressure", "radial_stress", "hoop_stress", "damage", "crushed", "cracked", "density"})
    grid.fields.push_back({name, 1, {}});
  grid.fields.push_back({"velocity", 3, {}});
  grid.fields.push_back({"stress", 9, {}});
  int number = 0;
  solver.for_bodies([&](const auto& body) { append_cells(grid, body, number++, scene); });
  return grid;
}

/// Where the wall of a hole is, m from its centre: the mean of its corners, or the innermost square's centre.
template <class Body>
double wall_radius(const Body& rock, const Scene& scene, std::size_t hole) {
  const auto [hole_x, hole_y] = scene.hole_centre(hole);
  if constexpr (requires { rock.shape.surface; }) {
    double sum = 0, corners = 0;
    for (const auto& edge : rock.shape.surface) {
      const auto& x = rock.shape.corner[edge.first];
      if (scene.nearest_hole(x[0], x[1]) == hole) sum += std::hypot(x[0] - hole_x, x[1] - hole_y), corners += 1;
    }
    return sum / corners;
  } else {
    double least = std::numeric_limits<double>::max();
    for (std::size_t p = 0; p < rock.size(); ++p)
      least = std::min(least, std::hypot(rock.x(0)[p] - hole_x, rock.x(1)[p] - hole_y));
    return least;
  }
}

/// Mean radial stress, Pa, of the rock within a cell of a hole's wall. The ring's mean: a single particle that shares a
/// cell with gas shows several times as much.
template <class Body>
double wall_radial_stress(const Body& rock, const Scene& scene, std::size_t hole) {
  const auto [hole_x, hole_y] = scene.hole_centre(hole);
  const double wall = wall_radius(rock, scene, hole);
  double stress = 0, volume = 0;
  for (std::size_t p = 0; p < rock.size(); ++p) {
    if (std::hypot(rock.x(0)[p] - hole_x, rock.x(1)[p] - hole_y) > wall + scene.grid.cell) continue;
    stress += rock.volume()[p] * polar_stress(rock, p, scene).rr;
    volume += rock.volume()[p];
  }
  return stress / volume;
}

/// Mean stress of the rock within a cell of the point.
template <class Body>
mpm::analysis::PolarStress probe(const Body& rock, const std::array<double, 2>& point, const Scene& scene) {
  mpm::analysis::PolarStress sum{};
  double volume = 0;
  for (std::size_t p = 0; p < rock.size(); ++p) {
    if (std::hypot(rock.x(0)[p] - point[0], rock.x(1)[p] - point[1]) > scene.grid.cell) continue;
    const auto s = polar_stress(rock, p, scene);
    sum.rr += rock.volume()[p] * s.rr, sum.tt += rock.volume()[p] * s.tt, sum.rt += rock.volume()[p] * s.rt;
    volume += rock.volume()[p];
  }
  return {sum.rr / volume, sum.tt / volume, sum.rt / volume};
}

/// Calls f(samples, count) with the rock's damage as the crack measures take it; particles beyond half damage count.
template <class Body, class F>
auto with_damage(const Body& rock, const Scene& scene, const F& f) {
  std::vector<double> x(rock.size()), y(rock.size()), damage(rock.size()), crushing(rock.size());
  const std::vector<double> volume(rock.volume(), rock.volume() + rock.size());
  for (std::size_t p = 0; p < rock.size(); ++p) {
    const auto [hole_x, hole_y] = scene.hole_centre(scene.nearest_hole(rock.x(0)[p], rock.x(1)[p]));
    x[p] = rock.x(0)[p] - hole_x, y[p] = rock.x(1)[p] - hole_y;
    const auto d = damage_of(rock.state(p));
    damage[p] = d.larger(), crushing[p] = d.crushed;
  }
  return f(mpm::analysis::DamageSamples{x, y, volume, damage, crushing},
           mpm::analysis::CrackCount{.ring_width = scene.rock.particle, .multiplicity = multiplicity(scene)});
}

/// Extent of the damage.
template <class Body>
Summary::Crack measure_cracks(const Body& rock, const Scene& scene) {
  const auto c = with_damage(rock, scene, mpm::analysis::crack_measures);
  return {c.reach, c.along_x, c.along_y, c.longest, c.area, c.crushed_area, c.crushed_radius};
}

/// Writes the reach of the damage by direction, every 10 degrees.
template <class Body>
void write_rose(const Body& rock, const Scene& scene, const std::filesystem::path& csv) {
  constexpr int sectors = 36;
  mpm::io::CsvWriter table(csv, {{"direction", "degrees"}, {"reach", "m"}});
  const auto rose = with_damage(rock, scene, [](const auto& samples, const auto& count) {
    return mpm::analysis::crack_rose(samples, count, sectors);
  });
  for (int k = 0; k < sectors; ++k) table.row(std::vector<double>{360.0 * k / sectors, rose[std::size_t(k)]});
}

/// Corners of a particle's domain.
template <class Body>
Quad domain_of(const Body& rock, std::size_t p) {
  Quad corners;
  if constexpr (requires { rock.shape.quad; }) {
    for (int c = 0; c < 4; ++c) corners[c] = rock.shape.corner[rock.shape.quad[p][c]];
  } else {
    const double x = rock.x(0)[p], y = rock.x(1)[p], a = rock.shape.half_size[0], b = rock.shape.half_size[1];
    corners = {{{x - a, y - b}, {x + a, y - b}, {x + a, y + b}, {x - a, y + b}}};
  }
  return corners;
}

/// Draws damage, hoop stress and pressure of the rock round the holes.
template <class Body>
void draw_rock(const Body& rock, const Scene& scene, const std::string& when, double half_width,
               const std::filesystem::path& folder) {
  std::vector<Quad> domains(rock.size());
  std::vector<double> damage(rock.size()), hoop(rock.size()), pressure(rock.size());
  for (std::size_t p = 0; p < rock.size(); ++p) {
    domains[p] = domain_of(rock, p);
    const auto d = damage_of(rock.state(p));
    damage[p] = signed_damage(d.crushed, d.cracked);
    hoop[p] = polar_stress(rock, p, scene).tt;
    pressure[p] = -trace(rock.stress(p)) / 3;
  }
  Picture picture{.title = when,
                  .centre = scene.middle(),
                  .holes = scene.hole_centres(),
                  .hole_radius = scene.hole.radius,
                  .half_width = half_width,
                  .quarter = scene.model == Model::quarter};
  picture.field = damage_field, draw_field(picture, domains, damage, folder / "damage.png");
  picture.field = hoop_stress_field, draw_field(picture, domains, hoop, folder / "hoop_stress.png");
  picture.field = pressure_field, draw_field(picture, domains, pressure, folder / "pressure.png");
}

/// Snapshots and tables of the blast as it goes.
template <class Solver>
class Recorder {
 public:
  Recorder(const Scene& scene, const std::filesystem::path& folder, double charge_energy)
      : scene_(scene),
        charge_energy_(charge_energy),
        snapshots_(folder / "blast"),
        energies_(folder / "energies.csv", {{"time", "s"},
                                            {"kinetic_rock", "J/m"},
                                            {"kinetic_charge", "J/m"},
                                            {"kinetic_air", "J/m"},
                                            {"work_rock", "J/m"},
                                            {"work_charge", "J/m"},
                                            {"work_air", "J/m"},
                                            {"boundary", "J/m"},
                                            {"balance", "J/m"}}),
        probes_(folder / "probes.csv", probe_columns(scene)),
        cracks_(folder / "cracks.csv", {{"time", "s"},
                                        {"reach", "m"},
                                        {"along_x", "m"},
                                        {"along_y", "m"},
                                        {"area", "m2"},
                                        {"crushed_area", "m2"}}),
        ledger_(folder / "ledger.csv", {{"time", "s"},
                                        {"charge", "J/m"},
                                        {"air", "J/m"},
                                        {"kinetic", "J/m"},
                                        {"elastic", "J/m"},
                                        {"fracture", "J/m"},
                                        {"viscosity", "J/m"},
                                        {"crushing", "J/m"},
                                        {"boundary", "J/m"},
                                        {"loss", "J/m"}}) {}

  /// A snapshot at each of the scene's output times, a row of the tables about every microsecond, one of cracks and
  /// ledger at every thirtieth of the time.
  void record(Solver& solver) {
    if (solver.time >= next_row_ || solver.time >= scene_.end_time) {
      rows(solver);
      next_row_ = solver.time + 1e-6;
    }
    if (solver.time >= next_cracks_ || solver.time >= scene_.end_time) {
      const auto c = measure_cracks(solver.template body<0>(), scene_);
      cracks_.row(std::vector<double>{solver.time, c.reach, c.along_x, c.along_y, c.area, c.crushed_area});
      settle_accounts(solver);
      next_cracks_ += scene_.end_time / 30;
    }
    if (solver.time < next_snapshot_time()) return;
    snapshots_.write(solver.time, snapshot_of(solver, scene_));
    ++taken_;
  }
  /// Time at which the next snapshot is due, s; the first is at the start, the last at the end.
  double next_snapshot_time() const {
    return taken_ > scene_.output.snapshots ? 2 * scene_.end_time
           : taken_ == scene_.output.snapshots
               ? scene_.end_time
               : scene_.end_time * double(taken_) / double(std::max(1, scene_.output.snapshots));
  }
  /// Largest part of the charge's energy that the ledger has missed, J per metre of the full plane.
  double largest_loss() const { return largest_loss_; }
  /// Largest compression that a wall has seen, Pa, tension positive.
  double wall_radial_stress() const { return wall_; }

 private:
  static std::vector<mpm::io::Column> probe_columns(const Scene& scene) {
    std::vector<mpm::io::Column> columns{{"time", "s"}, {"wall_radial_stress", "Pa"}};
    for (std::size_t k = 1; k < scene.holes(); ++k)
      columns.push_back({"wall_radial_stress_" + std::to_string(k + 1), "Pa"});
    for (std::size_t k = 0; k < scene.output.probes.size(); ++k) {
      std::string at = "_at_" + mpm::io::number(scene.output.probes[k]) + "m";
      if (!scene.output.probe_directions.empty()) at += "_" + mpm::io::number(scene.output.probe_directions[k]) + "deg";
      columns.push_back({"radial_stress" + at, "Pa"});
      columns.push_back({"hoop_stress" + at, "Pa"});
    }
    return columns;
  }
  void rows(Solver& solver) {
    const auto& rock = solver.template body<0>();
    const auto e = energies(solver, scene_, charge_energy_);
    std::vector<double> row{solver.time};
    for (const char* name : {"kinetic_rock", "kinetic_charge", "kinetic_air", "work_rock", "work_charge", "work_air",
                             "boundary", "balance"})
      row.push_back(e.at(name));
    energies_.row(row);
    row = {solver.time};
    for (std::size_t k = 0; k < scene_.holes(); ++k) {
      row.push_back(blasting::wall_radial_stress(rock, scene_, k));
      wall_ = std::min(wall_, row.back());
    }
    for (std::size_t k = 0; k < scene_.output.probes.size(); ++k) {
      const auto s = probe(rock, scene_.probe(k), scene_);
      row.insert(row.end(), {s.rr, s.tt});
    }
    probes_.row(row);
  }

  void settle_accounts(Solver& solver) {
    Ledger now = ledger(solver, scene_);
    if (solver.steps == 0) start_ = now;
    now.air -= start_.air, now.elastic -= start_.elastic;
    now.crushing =
        multiplicity(scene_) * solver.template body<0>().stress_work - now.elastic - now.fracture - now.viscosity;
    const double loss = charge_energy_ - now.sum();
    largest_loss_ = std::max(largest_loss_, std::abs(loss));
    ledger_.row(std::vector<double>{solver.time, now.charge, now.air, now.kinetic, now.elastic, now.fracture,
                                    now.viscosity, now.crushing, now.boundary, loss});
  }

  const Scene& scene_;
  double charge_energy_;
  mpm::io::SnapshotSeries snapshots_;
  mpm::io::CsvWriter energies_, probes_, cracks_, ledger_;
  double next_row_ = 0, next_cracks_ = 0, wall_ = 0, largest_loss_ = 0;
  Ledger start_{};
  int taken_ = 0;
};

}  // namespace blasting
