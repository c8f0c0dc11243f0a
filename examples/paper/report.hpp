// SPDX-License-Identifier: MIT
#pragma once
#include "claims.hpp"
#include "page.hpp"
#include <filesystem>
#include <vector>

// The parts of the report, each of which runs or computes what it shows, draws it, and writes its section.
namespace paper {

/// Where and how large.
struct Report {
  std::filesystem::path folder;
  bool quick = false;  ///< cells and particles of twice the paper's size
  Page page{};
  std::vector<Finding> findings{};
  TableOf states{};  ///< the twelve blasts

  /// Puts index.html and claims.md into the folder, as far as the report is.
  void write() const;
};

/// Fig. 8: stresses round a hole by Kirsch's solution.
void kirsch_curves(Report& report);
/// Fig. 9: the relaxed stress field, against Kirsch's.
void initial_stress(Report& report);
/// Fig. 10: stress histories round a hole under Blair's pulse.
void cavity_histories(Report& report);
/// Fig. 11: the twelve blasts, the claims on them over seeds.
void twelve_blasts(Report& report);
/// Figs. 5 and 6: a slab of marble with and without prestress.
void marble_slab(Report& report);
/// Where the charge's energy goes, and the pressure on the wall.
void energy_ledger(Report& report);
/// Two holes along and across the larger stress.
void hole_pairs(Report& report);
/// What the mesh does to the cracks.
void objectivity(Report& report);
/// What other readings of the paper's rock give.
void rock_readings(Report& report);
/// What each simplification of the scene changes and saves.
void economy(Report& report);

}  // namespace paper
