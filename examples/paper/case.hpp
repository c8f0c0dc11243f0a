// SPDX-License-Identifier: MIT
#pragma once
#include <blasting/scene.hpp>
#include <boost/property_tree/ptree.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

// Blasts that a report is made of, each in a folder of its own and run once.
namespace paper {

/// One run of the blasting program's parts.
struct Case {
  std::string name;  ///< of its folder
  blasting::Scene scene;
};

/// A column of a table that a run wrote, by its name without the unit.
using Columns = std::map<std::string, std::vector<double>>;

/// A run that was completed, or, where `problem` says why, was not.
struct Blast {
  blasting::Scene scene{};
  std::filesystem::path folder{};
  std::string problem{};
  boost::property_tree::ptree summary{};

  bool completed() const { return problem.empty(); }
  /// A number of summary.json, such as "crack.reach". NaN if the run was not completed.
  double number(const std::string& key) const;
  /// A table of the run, such as "cracks.csv". Throws std::runtime_error naming the file if it cannot be read.
  Columns table(const std::string& file) const;
};

/// Runs the case in `parent`/name, unless a run of the same scene is there, complete or failed. A run that fails is
/// recorded with its reason, not thrown. Throws mpm::io::InputError for a bad scene.
Blast run(const Case& one, const std::filesystem::path& parent);

/// Reads a table whose header reads `name [unit],...`. Throws std::runtime_error naming the file.
Columns read_columns(const std::filesystem::path& csv);

}  // namespace paper
