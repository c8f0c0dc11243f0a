// SPDX-License-Identifier: MIT
#pragma once
#include <accuracy_cost/table.hpp>
#include <string>

namespace accuracy_cost {

/// A row of the problem "test", double precision.
inline Row row(const std::string& shape, int cells, double error, double cost) {
  return {.problem = "test",
          .method = {shape, "USL", "FLIP", "double", 2, .8},
          .cells = cells,
          .error = error,
          .cost = cost,
          .particles = 2 * cells,
          .steps = 10 * cells,
          .bytes = 56};
}

}  // namespace accuracy_cost
