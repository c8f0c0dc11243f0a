// SPDX-License-Identifier: MIT
#include "table.hpp"
#include <mpm/io/csv.hpp>
#include <mpm/io/units.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include "unit_method.hpp"

namespace accuracy_cost {
namespace {

using mpm::io::InputError;
using mpm::io::number;

const std::vector<mpm::io::Column> columns{
    {"problem", "1"}, {"scene", "1"},         {"shape", "1"},    {"integrator", "1"}, {"transfer", "1"},
    {"scalar", "1"},  {"cells", "1"},         {"per edge", "1"}, {"CFL", "1"},        {"error", "1"},
    {"cost", "s"},    {"relative cost", "1"}, {"bytes", "B"},    {"particles", "1"},  {"steps", "1"}};

std::vector<std::string> cells_of(const Row& row) {
  const Method& m = row.method;
  return {row.problem,
          m.scene,
          m.shape,
          m.integrator,
          m.transfer,
          m.scalar,
          std::to_string(row.cells),
          std::to_string(m.per_edge),
          number(m.cfl),
          number(row.error),
          number(row.cost),
          number(row.relative_cost),
          std::to_string(row.bytes),
          std::to_string(row.particles),
          std::to_string(row.steps)};
}

Row row_of(const std::vector<std::string>& cell) {
  return {.problem = cell[0],
          .method = {cell[2], cell[3], cell[4], cell[5], std::stoi(cell[7]), std::stod(cell[8]), cell[1]},
          .cells = std::stoi(cell[6]),
          .error = std::stod(cell[9]),
          .cost = std::stod(cell[10]),
          .relative_cost = std::stod(cell[11]),
          .particles = std::stoll(cell[13]),
          .steps = std::stoll(cell[14]),
          .bytes = std::stoul(cell[12])};
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

std::string rounded(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::string name(const Method& m) {
  return (m.scene.empty() ? "" : m.scene + ": ") + m.shape + ' ' + m.integrator + ' ' + m.transfer +
         (m.scalar == "float" ? ", float" : "") + ", " + std::to_string(m.per_edge) + " an edge, CFL " + number(m.cfl);
}

Table rows_of(const Table& table, const std::string& problem) {
  Table rows;
  std::ranges::copy_if(table, std::back_inserter(rows), [&](const Row& row) { return row.problem == problem; });
  return rows;
}

void relate_costs(Table& rows) {
  for (Row& row : rows) {
    const Method unit = unit_method(row.method);
    const auto found =
        std::ranges::find_if(rows, [&](const Row& r) { return r.cells == row.cells && r.method == unit; });
    row.relative_cost = found == rows.end() ? std::numeric_limits<double>::quiet_NaN() : row.cost / found->cost;
  }
}

Table front(const Table& rows) {
  Table sorted;
  std::ranges::copy_if(rows, std::back_inserter(sorted), [](const Row& row) { return std::isfinite(row.error); });
  std::ranges::sort(sorted,
                    [](const Row& a, const Row& b) { return a.cost != b.cost ? a.cost < b.cost : a.error < b.error; });
  Table best;
  for (const Row& row : sorted)
    if (best.empty() || row.error < best.back().error) best.push_back(row);
  return best;
}

void write(const Table& table, const std::filesystem::path& file) {
  mpm::io::CsvWriter out(file, columns);
  for (const Row& row : table) out.row(cells_of(row));
}

Table read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || split(line).size() != columns.size() || !line.starts_with(columns.front().name))
    throw InputError(file.string() + ": cannot be read, or is no chart; make it anew");
  Table table;
  for (int at = 2; std::getline(in, line); ++at) {
    const auto cells = split(line);
    const std::string where = file.string() + ':' + std::to_string(at);
    if (cells.size() != columns.size()) throw InputError(where + ": not a row of a chart");
    try {
      table.push_back(row_of(cells));
    } catch (const std::logic_error&) {  // of std::stod and its kin
      throw InputError(where + ": a number is expected where there is none");
    }
  }
  return table;
}

std::string markdown(const Table& front) {
  std::string text =
      "| error | core-seconds | over linear USL | method | cells | bytes a particle |\n|---|---|---|---|---|---|\n";
  for (const Row& row : front)
    text += "| " + rounded(100 * row.error, "%.3g") + " % | " + rounded(row.cost, "%.2g") + " | " +
            (std::isfinite(row.relative_cost) ? rounded(row.relative_cost, "%.2f") : "-") + " | " + name(row.method) +
            " | " + std::to_string(row.cells) + " | " + std::to_string(row.bytes) + " |\n";
  return text;
}

}  // namespace accuracy_cost
