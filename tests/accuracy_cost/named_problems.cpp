// SPDX-License-Identifier: MIT
#include <accuracy_cost/problem.hpp>

namespace accuracy_cost {

std::vector<Problem> all_problems() {
  return {{.name = "bar", .title = "Bar of elastic rock"}, {.name = "cavity", .title = "Wave from a round hole"}};
}

}  // namespace accuracy_cost
