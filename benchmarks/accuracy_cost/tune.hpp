// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <vector>
#include "problem.hpp"

namespace accuracy_cost {

/// What the tuner proposes, and what it expects of it.
struct Choice {
  Method method{};
  int cells = 0;
  double error = 0;  ///< expected, without the margin
  double cost = 0;   ///< expected, core-seconds
};

/// By how much errors between two sizes exceed a power law through their neighbours: the largest ratio but for one in
/// twenty, over every size of the table that has a neighbour on either side and is left out in turn. 1 or more.
double margin(const Table& rows);

/// The cheapest method and size of a problem whose expected error, times the margin, stays within the budget; sizes are
/// multiples of `step`, within those of the table. Between two sizes error and cost follow power laws. A size counts
/// with the largest error of its method at that size or finer: a dip that the finer sizes do not confirm is luck.
std::optional<Choice> choose(const Table& rows, double budget, double margin, int step);

/// A choice, and what running it gave.
struct Attempt {
  Choice choice{};
  Row run{};
};

/// Names and runs until the budget is kept: without a margin first; after a miss with the table's, or with the factor
/// by which the run stood above what was expected, if that is more. Empty if the table knows nothing that keeps the
/// budget; the last run misses it if the table knows nothing better.
std::vector<Attempt> attempts(const Table& rows, double budget, int step, const std::function<Row(const Choice&)>& run);

}  // namespace accuracy_cost
