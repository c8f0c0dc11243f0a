// SPDX-License-Identifier: MIT
#include "chart.hpp"
#include <mpm/error.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include "unit_method.hpp"

namespace accuracy_cost {

using mpm::problems::Outcome;

Row measure(const Problem& problem, const Configuration& configuration, int cells, std::size_t variant) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Row row{.problem = problem.name, .method = configuration.method, .cells = cells, .error = nan, .cost = nan};
  std::vector<double> costs;
  double sum = 0;
  try {
    do {
      const Outcome outcome = configuration.run(cells, variant);
      if (!costs.empty() && outcome.error != row.error && std::isfinite(row.error))
        throw std::logic_error(problem.name + ", " + name(row.method) + ": a repetition has another error");
      row.error = outcome.error;
      row.particles = outcome.particles, row.steps = outcome.steps, row.bytes = outcome.bytes;
      costs.push_back(outcome.seconds);
      sum += outcome.seconds;
    } while (costs.size() < 3 ? costs.front() < 1 : sum < .02);
  } catch (const mpm::Error&) {
    return row;
  }
  std::ranges::sort(costs);
  row.cost = costs[costs.size() / 2];
  return row;
}

namespace {

double work(const Row& row) {
  return double(row.particles) * double(row.steps);
}

/// Particle-steps at `cells` if they grow as between the last two sizes; 0 where there is nothing to tell by.
double expected_work(const Table& line, int cells) {
  if (line.size() < 2) return 0;
  const Row &a = line[line.size() - 2], &b = line.back();
  const double growth = std::log(work(b) / work(a)) / std::log(double(b.cells) / a.cells);
  return work(b) * std::pow(double(cells) / b.cells, growth);
}

}  // namespace

Table measure_all(const Problem& problem, std::size_t variant, Extent extent, const Progress& progress) {
  const bool quick = extent == Extent::quick;
  Table table;
  for (const Configuration& configuration : problem.configurations) {
    if (quick && !configuration.quick) continue;
    // What only a full chart has differs from the usual on the smaller sizes as well.
    const double most_work = quick ? 1e6 : configuration.quick ? 2e7 : 4e6;
    Table line;
    for (const int cells : quick ? problem.quick : problem.full) {
      // Linear shapes step ever shorter as they are refined, but the others' costs are told in theirs.
      const bool is_unit = configuration.method == unit_method(configuration.method);
      if (!is_unit && expected_work(line, cells) > most_work) break;
      if (progress) progress(problem, configuration.method, cells);
      line.push_back(measure(problem, configuration, cells, variant));
      if (!std::isfinite(line.back().error)) break;
    }
    table.insert(table.end(), line.begin(), line.end());
  }
  relate_costs(table);
  return table;
}

}  // namespace accuracy_cost
