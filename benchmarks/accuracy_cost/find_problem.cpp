// SPDX-License-Identifier: MIT
#include <mpm/io/units.hpp>
#include "problem.hpp"

namespace accuracy_cost {

Problem find_problem(const std::string& name) {
  std::string names;
  for (Problem& problem : all_problems()) {
    if (problem.name == name) return std::move(problem);
    names += (names.empty() ? "" : ", ") + problem.name;
  }
  throw mpm::io::InputError("--problem " + mpm::io::shown(name) + ": there is none of that name; there are " + names);
}

}  // namespace accuracy_cost
