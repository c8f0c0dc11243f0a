// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>

namespace blasting {

/// What a run found, as `summary.json` says it: the same names, SI units. A number that was never found is NaN here and
/// null there.
struct Summary {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  bool completed = false;
  double simulated_seconds = 0;
  double wall_seconds = 0, cpu_seconds = 0;
  struct Steps {
    std::int64_t relaxation = 0, blast = 0;
  } steps{};
  struct Particles {
    std::int64_t rock = 0, charge = 0, air = 0;
  } particles{};
  /// Where the relaxation ended: out-of-balance over internal forces, kinetic over internal energy.
  struct Relaxation {
    double unbalanced_force = unknown, kinetic_ratio = unknown;
  } relaxation{};
  /// Damaged rock around the holes: distances from the nearest centre, m, and areas of the full plane, m2.
  struct Crack {
    double reach = unknown, along_x = unknown, along_y = unknown, longest = unknown, area = unknown,
           crushed_area = unknown, crushed_radius = unknown;
  } crack{};
  double wall_radial_stress = unknown;     ///< Pa, tension positive
  std::map<std::string, double> energy{};  ///< J/m
  int threads = 0;
  std::string state_hash{};  ///< of every particle's whole state, hexadecimal: equal runs, equal bits
};

/// Writes the summary as JSON, whole or not at all; numbers read back to the bit. Throws std::runtime_error naming the
/// file if it cannot be written.
void write_summary(const std::filesystem::path& file, const Summary& summary);

}  // namespace blasting
