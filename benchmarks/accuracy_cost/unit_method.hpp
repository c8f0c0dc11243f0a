// SPDX-License-Identifier: MIT
#pragma once
#include "table.hpp"

namespace accuracy_cost {

/// What the cost of a method is related to: linear shapes with USL and FLIP in double precision, at the same setting.
inline Method unit_method(const Method& method) {
  return {"Linear", "USL", "FLIP", "double", method.per_edge, method.cfl, method.scene};
}

}  // namespace accuracy_cost
