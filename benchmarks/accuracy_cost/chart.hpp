// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include "problem.hpp"

namespace accuracy_cost {

/// Runs one configuration: alone on one thread, at least three times where it is shorter than a second, and takes the
/// median of the costs. A run that fails is a row without error and cost. Throws mpm::Error if a repetition gives other
/// bits.
Row measure(const Problem& problem, const Configuration& configuration, int cells, std::size_t variant);

/// Called before each run, with what it is.
using Progress = std::function<void(const Problem&, const Method&, int cells)>;

enum class Extent { quick, full };

/// Measures the configurations of a variant of the problem at the chart's sizes, coarse to fine. A size is left out
/// where by the ones before it would take too many particle-steps, unless the others need it as the unit of cost, and
/// where a coarser one failed.
Table measure_all(const Problem& problem, std::size_t variant, Extent extent, const Progress& progress = {});

}  // namespace accuracy_cost
