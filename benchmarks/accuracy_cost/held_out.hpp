// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include "tune.hpp"

namespace accuracy_cost {

/// The tuner put to the test on a variant that its table does not hold.
struct Trial {
  std::string variant;
  double budget = 0;
  Choice choice{};  ///< the last
  std::size_t runs = 1;
  double error = 0;  ///< true
  double cost = 0;   ///< of the choice
  double best = 0;   ///< of what the variant's own table would have named, without a margin
  bool kept() const { return error <= budget; }
  double cost_ratio() const { return cost / best; }
};

/// Measures a configuration at a size on a variant; its cost may be seconds or work.
using Measure = std::function<Row(const Configuration&, int cells, std::size_t variant)>;

/// Tunes for every budget of 10, 5, 2, 1, .5 and .2 % that the variant's own table `own` and the chart's table both
/// reach, and compares with the best. Below, what is exact only for small displacements no longer is.
std::vector<Trial> try_out(const Problem& problem, const Table& chart, const Table& own, std::size_t variant,
                           const Measure& measure);

/// How often budgets were kept, and the cost ratios, as a line of text and a Markdown table.
std::string report(const std::vector<Trial>& trials);

}  // namespace accuracy_cost
