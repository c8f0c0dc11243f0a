// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/geometry/holed_block.hpp>
#include <mpm/io/parameters.hpp>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

// The scene of blast holes in pre-stressed rock (Xiao et al. 2024, Processes 12, 1048, sections 3.3 and 3.4).
namespace blasting {

using mpm::geometry::Model;
enum class ChargeKind { petn, none };
enum class ChargePreset { petn_1260, petn_as_printed };
enum class Burn { constant_volume, programmed };
enum class RockLaw { jh2, elastic };
enum class RockShape { cpdi2, ugimp };
enum class RockPreset { paper, granite_1200, granite_3000 };
enum class TensileLaw { rankine, none };
enum class StressStart { kirsch, far_field };
enum class Faces { quiet, free };
enum class StressUpdate { usl, musl, usf };
enum class Precision { automatic, double_, float_ };

/// Every parameter of a run, in SI. The member initialisers are the default scene. An optional member, when set,
/// replaces the preset's value. Meanings, units and valid values: `parameters`.
struct Scene {
  Model model = Model::quarter;

  struct Hole {
    double radius = 0.021;
    std::vector<double> x{0}, y{0};  ///< one entry a hole
  } hole;

  struct Charge {
    ChargeKind kind = ChargeKind::petn;
    double radius = 0.016, x = 0, y = 0;
    ChargePreset preset = ChargePreset::petn_1260;
    Burn burn = Burn::constant_volume;
    std::vector<double> delay{};  ///< one a hole, or none: all are lit at the start
    std::optional<double> density, detonation_velocity, A, B, R1, R2, omega, E0;
  } charge;

  struct Air {
    bool fill = true;
    double density = 1.225, energy = 250e3;
  } air;

  struct Block {
    double side = 2.4;
    Faces faces = Faces::quiet;
  } block;

  struct Grid {
    double cell = 0.01;
  } grid;

  struct Rock {
    double particle = 0.005;
    RockShape shape = RockShape::cpdi2;
    RockLaw law = RockLaw::jh2;
    RockPreset preset = RockPreset::paper;
    std::optional<double> density, young, poisson, A, B, C, M, N, tensile_pressure, sigma_hel, p_hel, beta, D1, D2, K1,
        K2, K3, max_fracture_strength;

    struct Tensile {
      TensileLaw law = TensileLaw::rankine;
      double strength = 54e6, fracture_energy = 500, weibull_modulus = 6;
    } tensile;
  } rock;

  int seed = 1;

  /// In-situ stress as magnitudes: compression positive, as in the paper and only here.
  struct Stress {
    double horizontal = 20e6, vertical = 20e6, direction = 0;
    StressStart start = StressStart::kirsch;
  } stress;

  struct Relaxation {
    double tolerance = 1e-6;
    int max_steps = 20000;
  } relaxation;

  struct Gas {
    int particles_per_edge = 4;
  } gas;

  struct Step {
    double safety = 0.8;
    StressUpdate update = StressUpdate::musl;
    double flip = 1;
    double rest_speed = 1e-3;
    Precision precision = Precision::automatic;
  } step;

  double end_time = 300e-6;

  struct Output {
    int snapshots = 6;
    std::vector<double> probes{0.1, 0.2};
    std::vector<double> probe_directions{};
  } output;

  std::size_t holes() const { return hole.x.size(); }
  /// Where hole k is, m from the centre of the block; where all are; the one nearest to a point; the middle of all.
  std::array<double, 2> hole_centre(std::size_t k) const { return {hole.x[k], hole.y[k]}; }
  std::vector<std::array<double, 2>> hole_centres() const;
  std::size_t nearest_hole(double x, double y) const;
  std::array<double, 2> middle() const;
  /// When the charge of hole k is lit, s.
  double lighting_time(std::size_t k) const { return charge.delay.empty() ? 0 : charge.delay[k]; }
  /// Where probe k is, m from the centre of the block.
  std::array<double, 2> probe(std::size_t k) const;
};

/// The one list of keys, bound to the members of `scene`; its values are the defaults where `scene` is a fresh one.
mpm::io::Parameters parameters(Scene& scene);

/// Checks every range, and what no single value shows: the charge fits the hole, the holes fit the block and are
/// apart, a quarter model has a symmetric scene, a particle fits a cell, the probes lie in the rock. Throws
/// mpm::io::InputError.
void validate(const Scene& scene);

/// Writes a scene file that reproduces the run. Throws mpm::io::InputError where it cannot be written.
void write_scene(const Scene& scene, const std::filesystem::path& path);

}  // namespace blasting
