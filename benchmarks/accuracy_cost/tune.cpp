// SPDX-License-Identifier: MIT
#include "tune.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace accuracy_cost {
namespace {

/// y at x on the power law through two points.
double power_law(double x0, double y0, double x1, double y1, double x) {
  return y0 * std::pow(y1 / y0, std::log(x / x0) / std::log(x1 / x0));
}

/// The rows of each method, coarse to fine.
std::map<Method, Table> lines_of(const Table& rows) {
  std::map<Method, Table> lines;
  for (const Row& row : rows) lines[row.method].push_back(row);
  for (auto& [method, line] : lines) std::ranges::sort(line, {}, &Row::cells);
  return lines;
}

bool usable(const Row& row) {
  return row.error > 0 && row.cost > 0 && std::isfinite(row.error) && std::isfinite(row.cost);
}

/// Every error becomes the largest at that size or finer; NaN counts as infinite.
void confirm(Table& line) {
  double largest = 0;
  for (auto row = line.rbegin(); row != line.rend(); ++row) {
    if (!usable(*row)) row->error = std::numeric_limits<double>::infinity();
    row->error = largest = std::max(largest, row->error);
  }
}

/// The smallest size of a confirmed line that is expected to stay within `most`.
std::optional<Choice> choose_on(const Table& line, double most, int step) {
  const auto within = std::ranges::find_if(line, [&](const Row& row) { return row.error <= most; });
  if (within == line.end()) return {};
  Choice choice{within->method, within->cells, within->error, within->cost};
  if (within == line.begin()) return choice;
  const Row &coarse = *(within - 1), &fine = *within;
  if (!std::isfinite(coarse.error)) return choice;
  for (int cells = (coarse.cells / step + 1) * step; cells < fine.cells; cells += step) {
    const auto between = [&](double a, double b) { return power_law(coarse.cells, a, fine.cells, b, cells); };
    const double error = between(coarse.error, fine.error);
    if (error <= most) return Choice{fine.method, cells, error, between(coarse.cost, fine.cost)};
  }
  return choice;
}

}  // namespace

double margin(const Table& rows) {
  std::vector<double> ratios;
  for (const auto& [method, line] : lines_of(rows))
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Row &a = line[i - 1], &b = line[i], &c = line[i + 1];
      if (usable(a) && usable(b) && usable(c))
        ratios.push_back(b.error / power_law(a.cells, a.error, c.cells, c.error, b.cells));
    }
  if (ratios.empty()) return 1;
  std::ranges::sort(ratios);
  return std::max(1., ratios[(ratios.size() - 1) * 19 / 20]);
}

std::optional<Choice> choose(const Table& rows, double budget, double margin, int step) {
  std::optional<Choice> best;
  for (auto& [method, line] : lines_of(rows)) {
    Table confirmed = line;
    confirm(confirmed);
    const auto choice = choose_on(confirmed, budget / margin, step);
    if (choice && (!best || choice->cost < best->cost)) best = choice;
  }
  return best;
}

std::vector<Attempt> attempts(const Table& rows, double budget, int step,
                              const std::function<Row(const Choice&)>& run) {
  std::vector<Attempt> made;
  for (double share = 1; const auto choice = choose(rows, budget, share, step);) {
    made.push_back({*choice, run(*choice)});
    const double error = made.back().run.error;
    if (error <= budget) break;
    // What was named is not named again: its expected error times the share is the true one, or twice the budget.
    share = std::max(margin(rows), (std::isfinite(error) ? error : 2 * budget) / choice->error);
  }
  return made;
}

}  // namespace accuracy_cost
