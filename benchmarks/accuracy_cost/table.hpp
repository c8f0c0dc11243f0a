// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace accuracy_cost {

/// How a problem is solved, in the words of tables and pictures; all but the size.
struct Method {
  std::string shape;       ///< "Cpdi"
  std::string integrator;  ///< when stresses are updated: "USF", "USL" or "MUSL"
  std::string transfer;    ///< "FLIP", "FMPM(2)", ...
  std::string scalar;      ///< "double" or "float"
  int per_edge = 0;        ///< particles an edge of a cell
  double cfl = 0;          ///< share of the stable step, `Solver::safety`
  std::string scene{};     ///< what is modelled, where a problem leaves that open

  friend bool operator==(const Method&, const Method&) = default;
  friend auto operator<=>(const Method&, const Method&) = default;
};

/// "full plane: Cpdi USL FLIP, float, 2 an edge, CFL 0.8"; double precision goes without saying.
std::string name(const Method& method);

/// One run of a problem. Error and cost are NaN where the run failed.
struct Row {
  std::string problem{};
  Method method{};
  int cells = 0;             ///< the problem's own measure of its resolution
  double error = 0;          ///< relative, in the problem's own norm
  double cost = 0;           ///< core-seconds of the steps, median
  double relative_cost = 0;  ///< over linear shapes with USL at the same size; NaN where those failed
  std::int64_t particles = 0;
  std::int64_t steps = 0;
  std::size_t bytes = 0;  ///< a particle
};
using Table = std::vector<Row>;

/// The rows of one problem.
Table rows_of(const Table& table, const std::string& problem);

/// Sets the relative costs of rows of one problem.
void relate_costs(Table& rows);

/// The rows that no other row of the same problem beats in error and cost, by falling error.
Table front(const Table& rows);

/// Writes the table as CSV. Throws std::runtime_error naming the file if it cannot be written.
void write(const Table& table, const std::filesystem::path& file);

/// Reads what `write` wrote. Throws mpm::io::InputError naming file and line.
Table read(const std::filesystem::path& file);

/// The front as a Markdown table.
std::string markdown(const Table& front);

}  // namespace accuracy_cost
