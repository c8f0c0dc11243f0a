// SPDX-License-Identifier: MIT
#include "scene.hpp"
#include <mpm/io/info_file.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <utility>

namespace blasting {
namespace {

using mpm::io::Choice;
using mpm::io::InputError;
using mpm::io::Parameters;
using mpm::io::Range;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range positive{0, infinity, true};
constexpr Range not_negative{0, infinity};
constexpr Range any{};
constexpr Range solid_density{100, 30000};  // refuses a density in g/cm^3 without its unit
constexpr Range modulus{1e3, 1e13};

Parameters hole_and_charge(Scene& s) {
  auto& c = s.charge;
  return {
      {"model", Choice(s.model, {"full", "quarter"}), "", "quarter: one quadrant between symmetry rollers"},
      {"hole.radius", &s.hole.radius, "mm", "radius of the blast holes", positive},
      {"hole.x", &s.hole.x, "mm", "centres of the holes from the centre of the block, with commas (not 0: model full)",
       any},
      {"hole.y", &s.hole.y, "mm", "the same, vertical", any},
      {"charge.kind", Choice(c.kind, {"petn", "none"}), "", "explosive in the hole"},
      {"charge.radius", &c.radius, "mm", "radius of the charge", positive},
      {"charge.x", &c.x, "mm", "centre of the charge from the centre of the hole (not 0: model full)", any},
      {"charge.y", &c.y, "mm", "the same, vertical", any},
      {"charge.preset", Choice(c.preset, {"petn_1260", "petn_as_printed"}), "",
       "JWL constants: at the density they fit, or density and speed as printed in the paper"},
      {"charge.burn", Choice(c.burn, {"constant_volume", "programmed"}), "",
       "all products at once, or lit from the charge's centre at the detonation velocity"},
      {"charge.delay", &c.delay, "us", "when the charge of each hole is lit, with commas (none: all at the start)",
       not_negative},
      {"charge.density", &c.density, "kg/m^3", "density of the charge", {100, 10000}},
      {"charge.detonation_velocity", &c.detonation_velocity, "m/s", "speed of the programmed burn", {100, 20000}},
      {"charge.A", &c.A, "GPa", "JWL pressure A", positive},
      {"charge.B", &c.B, "GPa", "JWL pressure B", not_negative},
      {"charge.R1", &c.R1, "", "JWL exponent R1", positive},
      {"charge.R2", &c.R2, "", "JWL exponent R2", positive},
      {"charge.omega", &c.omega, "", "JWL Grueneisen coefficient", positive},
      {"charge.E0", &c.E0, "kJ/m^3", "JWL energy per initial volume", positive},
      {"air.fill", &s.air.fill, "", "fill the hole around the charge with air"},
      {"air.density", &s.air.density, "kg/m^3", "density of the air", {0, 100, true}},
      {"air.energy", &s.air.energy, "kJ/m^3", "internal energy of the air per initial volume", positive},
      {"gas.particles_per_edge", &s.gas.particles_per_edge, "", "gas particles along the edge of a cell", {1, 40}},
  };
}

Parameters rock(Scene& s) {
  auto& r = s.rock;
  return {
      {"block.side", &s.block.side, "m", "full side of the square block of rock", positive},
      {"block.faces", Choice(s.block.faces, {"quiet", "free"}), "",
       "outer sides during the blast: waves pass as into endless rock, or the slab ends there under its in-situ load"},
      {"grid.cell", &s.grid.cell, "mm", "side of a cell of the background grid", positive},
      {"rock.particle", &r.particle, "mm", "side of a rock particle", positive},
      {"rock.shape", Choice(r.shape, {"cpdi2", "ugimp"}), "",
       "particles of the rock: quadrilaterals that follow the holes and keep together, or squares of a lattice"},
      {"rock.law", Choice(r.law, {"jh2", "elastic"}), "", "Johnson-Holmquist 2, or linear elastic without damage"},
      {"rock.preset", Choice(r.preset, {"paper", "granite_1200", "granite_3000"}), "", "constants of the rock"},
      {"rock.density", &r.density, "kg/m^3", "initial density", solid_density},
      {"rock.young", &r.young, "MPa", "Young's modulus", modulus},
      {"rock.poisson", &r.poisson, "", "Poisson's ratio", {0, 0.49}},
      {"rock.A", &r.A, "", "JH-2 intact strength A", not_negative},
      {"rock.B", &r.B, "", "JH-2 fractured strength B", not_negative},
      {"rock.C", &r.C, "", "JH-2 strain-rate coefficient C", not_negative},
      {"rock.M", &r.M, "", "JH-2 fractured exponent M", not_negative},
      {"rock.N", &r.N, "", "JH-2 intact exponent N", not_negative},
      {"rock.tensile_pressure", &r.tensile_pressure, "MPa", "JH-2 largest tensile pressure T", positive},
      {"rock.sigma_hel", &r.sigma_hel, "MPa", "JH-2 equivalent stress at the Hugoniot elastic limit", positive},
      {"rock.p_hel", &r.p_hel, "MPa", "JH-2 pressure at the Hugoniot elastic limit", positive},
      {"rock.beta", &r.beta, "", "JH-2 share of the lost elastic energy that becomes pressure", {0, 1}},
      {"rock.D1", &r.D1, "", "JH-2 damage coefficient D1", positive},
      {"rock.D2", &r.D2, "", "JH-2 damage exponent D2", not_negative},
      {"rock.K1", &r.K1, "GPa", "bulk modulus, linear term of the pressure", modulus},
      {"rock.K2", &r.K2, "GPa", "quadratic term of the pressure", any},
      {"rock.K3", &r.K3, "GPa", "cubic term of the pressure", any},
      {"rock.max_fracture_strength", &r.max_fracture_strength, "", "JH-2 largest fractured strength", not_negative},
      {"rock.tensile.law", Choice(r.tensile.law, {"rankine", "none"}), "",
       "cracking in tension beside JH-2 (the elastic rock has none)"},
      {"rock.tensile.strength", &r.tensile.strength, "MPa", "tensile strength, the mean of its scatter", positive},
      {"rock.tensile.fracture_energy", &r.tensile.fracture_energy, "J/m^2", "energy to open a unit area of crack",
       positive},
      {"rock.tensile.weibull_modulus", &r.tensile.weibull_modulus, "", "scatter of the strength; 0: none", {0, 1000}},
      {"seed", &s.seed, "", "seed of the scatter", not_negative},
  };
}

Parameters stages(Scene& s) {
  return {
      {"stress.horizontal", &s.stress.horizontal, "MPa", "principal in-situ stress, compression positive", {0, 1e9}},
      {"stress.vertical", &s.stress.vertical, "MPa", "the one across it, compression positive", {0, 1e9}},
      {"stress.direction", &s.stress.direction, "", "direction of stress.horizontal, degrees from x", {-180, 180}},
      {"stress.start", Choice(s.stress.start, {"kirsch", "far_field"}), "", "stress field the relaxation starts from"},
      {"relaxation.tolerance",
       &s.relaxation.tolerance,
       "",
       "unbalanced force at which the rock is at rest",
       {0, 1, true}},
      {"relaxation.max_steps", &s.relaxation.max_steps, "", "largest number of relaxation steps", {1, 1e8}},
      {"step.safety", &s.step.safety, "", "share of the largest stable step", {0, 1, true}},
      {"step.update", Choice(s.step.update, {"usl", "musl", "usf"}), "",
       "stress updated last, modified last, or first"},
      {"step.flip", &s.step.flip, "", "share of FLIP in the FLIP-PIC blend", {0, 1}},
      {"step.rest_speed",
       &s.step.rest_speed,
       "m/s",
       "rock rests at no cost until something near it moves faster; 0: none does",
       {0, 1}},
      {"step.precision", Choice(s.step.precision, {"auto", "double", "float"}), "",
       "numbers of the blast; auto: float, half the bytes, for JH-2 with the tensile law on cpdi2, double for other "
       "rock"},
      {"end_time", &s.end_time, "us", "simulated time of the blast", {0, 1, true}},
      {"output.snapshots", &s.output.snapshots, "", "snapshots of the blast, the last at the end time", {0, 100000}},
      {"output.probes", &s.output.probes, "m", "distances from the first hole's centre, with commas, or none",
       positive},
      {"output.probe_directions", &s.output.probe_directions, "",
       "directions of the probes, degrees from x, one each (none: all along x)", any},
  };
}

[[noreturn]] void fail(const char* key, const std::vector<double>& values, const char* unit,
                       const std::string& problem) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + mpm::io::format_quantity(value, unit);
  throw InputError(std::string(key) + " = " + (text.empty() ? "none" : text) + ": " + problem);
}
[[noreturn]] void fail(const char* key, double value, const char* unit, const std::string& problem) {
  fail(key, std::vector{value}, unit, problem);
}

std::string millimetres(double metres) {
  return mpm::io::format_quantity(metres, "mm");
}

void check_holes(const Scene& s) {
  if (s.hole.x.empty()) fail("hole.x", s.hole.x, "mm", "a blast needs a hole");
  if (s.hole.x.size() != s.hole.y.size())
    fail("hole.y", s.hole.y, "mm",
         "each hole needs both coordinates, and hole.x has " + std::to_string(s.hole.x.size()));
  if (!s.charge.delay.empty() && s.charge.delay.size() != s.holes())
    fail("charge.delay", s.charge.delay, "us",
         "give one delay a hole, and there are " + std::to_string(s.holes()) + " in hole.x, or none");
  // The body-fitted rings around a hole need this many radii of rock before the mesh turns square.
  constexpr double room = 3;
  const auto inside = [&](const char* key, double centre) {
    const double gap = s.block.side / 2 - std::abs(centre);
    if (gap >= room * s.hole.radius) return;
    const std::string where =
        gap < s.hole.radius ? "the hole leaves the block" : "the hole is too close to the block's side";
    const std::string reach = "its centre must stay " + millimetres(room * s.hole.radius) + " (3 radii) inside";
    if (centre == 0)
      fail("block.side", s.block.side, "m", where + "; " + reach + ", raise block.side or lower hole.radius");
    fail(key, centre, "mm", where + "; " + reach + " a block.side of " + mpm::io::format_quantity(s.block.side, "m"));
  };
  for (const double x : s.hole.x) inside("hole.x", x);
  for (const double y : s.hole.y) inside("hole.y", y);
  for (std::size_t i = 0; i < s.holes(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double dx = s.hole.x[i] - s.hole.x[j], dy = s.hole.y[i] - s.hole.y[j];
      if (std::max(std::abs(dx), std::abs(dy)) >= 2 * room * s.hole.radius * (1 - 1e-12)) continue;
      const std::string which = "holes " + std::to_string(j + 1) + " and " + std::to_string(i + 1);
      fail("hole.x", s.hole.x, "mm",
           which + (std::hypot(dx, dy) < 2 * s.hole.radius ? " overlap" : " are too close to each other") +
               "; set them at least " + millimetres(2 * room * s.hole.radius) + " (6 radii) apart along x or y");
    }
}

void check_charge(const Scene& s) {
  if (s.charge.kind == ChargeKind::none) return;
  const std::string hole = "hole.radius = " + millimetres(s.hole.radius);
  if (s.charge.radius > s.hole.radius)
    fail("charge.radius", s.charge.radius, "mm", "the charge is wider than the hole, keep it at most " + hole);
  const double offset = std::hypot(s.charge.x, s.charge.y);
  if (offset + s.charge.radius > s.hole.radius * (1 + 1e-12))
    fail(s.charge.x != 0 ? "charge.x" : "charge.y", s.charge.x != 0 ? s.charge.x : s.charge.y, "mm",
         "the charge sticks out of the hole, keep its offset plus charge.radius at most " + hole);
  if (s.charge.detonation_velocity && s.charge.burn == Burn::constant_volume)
    fail("charge.detonation_velocity", *s.charge.detonation_velocity, "m/s",
         "a constant-volume burn has none, set charge.burn to programmed");
}

void check_symmetry(const Scene& s) {
  if (s.model == Model::full) return;
  if (s.holes() > 1) fail("hole.x", s.hole.x, "mm", "a quarter model has one hole, set model to full");
  const std::pair<const char*, double> offsets[] = {
      {"hole.x", s.hole.x[0]}, {"hole.y", s.hole.y[0]}, {"charge.x", s.charge.x}, {"charge.y", s.charge.y}};
  for (const auto& [key, value] : offsets)
    if (value != 0) fail(key, value, "mm", "a quarter model needs a symmetric scene, set model to full");
  if (s.stress.horizontal != s.stress.vertical && std::fmod(s.stress.direction, 90) != 0)
    fail("stress.direction", s.stress.direction, "",
         "a quarter model needs its principal stresses along x and y, take a multiple of 90 or set model to full");
}

void check_resolution(const Scene& s) {
  if (s.grid.cell > s.hole.radius)
    fail("grid.cell", s.grid.cell, "mm",
         "the hole falls through the grid, keep the cell at most hole.radius = " + millimetres(s.hole.radius));
  if (s.rock.particle > s.grid.cell)
    fail("rock.particle", s.rock.particle, "mm",
         "a rock particle is wider than a cell, keep it at most grid.cell = " + millimetres(s.grid.cell));
  constexpr double most = 1e9;  // no machine this program runs on holds more
  const double particles = std::pow(s.block.side / s.rock.particle, 2) / (s.model == Model::quarter ? 4 : 1);
  if (particles > most)
    fail("rock.particle", s.rock.particle, "mm",
         "this makes more than 1e9 rock particles, raise it or lower block.side");
}

/// Kinds of rock that the program was compiled for; see run.cpp.
void check_kind(const Scene& s) {
  const bool cracking = s.rock.law == RockLaw::jh2 && s.rock.tensile.law == TensileLaw::rankine;
  if (s.rock.shape == RockShape::ugimp && !cracking)
    throw InputError(
        "rock.shape = ugimp: only for rock.law = jh2 with rock.tensile.law = rankine, set those or keep the default");
  if (s.step.precision == Precision::float_ && (s.rock.shape == RockShape::ugimp || !cracking))
    throw InputError(
        "step.precision = float: only for rock.law = jh2 with rock.tensile.law = rankine on rock.shape = cpdi2, set "
        "those or keep the default");
}

void check_probes(const Scene& s) {
  const auto& directions = s.output.probe_directions;
  if (!directions.empty() && directions.size() != s.output.probes.size())
    throw InputError("output.probe_directions: " + std::to_string(directions.size()) + " directions for " +
                     std::to_string(s.output.probes.size()) + " output.probes, give each one");
  for (std::size_t k = 0; k < s.output.probes.size(); ++k) {
    const double probe = s.output.probes[k], half = s.block.side / 2;
    const auto [x, y] = s.probe(k);
    const auto [hole_x, hole_y] = s.hole_centre(s.nearest_hole(x, y));
    const double low = s.model == Model::quarter ? -1e-9 : -half;
    if (std::hypot(x - hole_x, y - hole_y) <= s.hole.radius || x >= half || y >= half || x <= low || y <= low)
      fail("output.probes", probe, "m",
           "not in the rock, keep it beyond " + millimetres(s.hole.radius) + " and within the " +
               (s.model == Model::quarter ? "quarter" : "block"));
  }
}

}  // namespace

std::vector<std::array<double, 2>> Scene::hole_centres() const {
  std::vector<std::array<double, 2>> centres;
  for (std::size_t k = 0; k < holes(); ++k) centres.push_back(hole_centre(k));
  return centres;
}

std::size_t Scene::nearest_hole(double x, double y) const {
  const auto distance = [&](std::size_t k) { return std::hypot(x - hole.x[k], y - hole.y[k]); };
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < holes(); ++k)
    if (distance(k) < distance(nearest)) nearest = k;
  return nearest;
}

std::array<double, 2> Scene::middle() const {
  std::array<double, 2> sum{};
  for (std::size_t k = 0; k < holes(); ++k)
    sum[0] += hole.x[k] / double(holes()), sum[1] += hole.y[k] / double(holes());
  return sum;
}

std::array<double, 2> Scene::probe(std::size_t k) const {
  const double direction = output.probe_directions.empty() ? 0 : output.probe_directions[k] * M_PI / 180;
  const double x = output.probes[k] * std::cos(direction), y = output.probes[k] * std::sin(direction);
  return {hole.x[0] + x, hole.y[0] + y};
}

Parameters parameters(Scene& scene) {
  Parameters all = hole_and_charge(scene);
  for (auto& parameter : rock(scene)) all.push_back(std::move(parameter));
  for (auto& parameter : stages(scene)) all.push_back(std::move(parameter));
  return all;
}

void validate(const Scene& scene) {
  Scene copy = scene;
  for (const auto& parameter : parameters(copy)) mpm::io::check_range(parameter);
  check_charge(scene);
  check_holes(scene);
  check_symmetry(scene);
  check_resolution(scene);
  check_kind(scene);
  check_probes(scene);
}

void write_scene(const Scene& scene, const std::filesystem::path& path) {
  Scene copy = scene;
  std::ofstream file(path);
  file << "; Every parameter of this run. A bare number is SI; stresses are compression positive.\n";
  mpm::io::write_info(file, parameters(copy));
  file.flush();
  if (!file) throw InputError("cannot write " + mpm::io::shown(path.string()) + ": check free space and permissions");
}

}  // namespace blasting
