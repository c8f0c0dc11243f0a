// SPDX-License-Identifier: MIT
#include "problem.hpp"

namespace accuracy_cost {

std::vector<Problem> all_problems() {
  return {axis_aligned(), vortex(), cavity(), radial_cavity(), kirsch(), sod(), axial_bar(), space(), gas()};
}

}  // namespace accuracy_cost
