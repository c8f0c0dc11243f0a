// SPDX-License-Identifier: MIT
#pragma once
#include <problems/outcome.hpp>
#include <functional>
#include <string>
#include <vector>
#include "table.hpp"

namespace accuracy_cost {

/// A method, compiled: runs a variant of a problem at a size.
struct Configuration {
  Method method{};
  bool quick = true;  ///< is part of a quick chart
  std::function<mpm::problems::Outcome(int cells, std::size_t variant)> run{};
};

/// A problem with an exact solution and the methods that can solve it.
struct Problem {
  std::string name{};                   ///< on the command line
  std::string title{};                  ///< over its picture, with what its error is
  std::vector<std::string> variants{};  ///< its parameters; the first are the chart's, the others held out
  std::vector<int> quick{}, full{};     ///< cells: what is charted
  int step = 1;                         ///< cells come in multiples of this
  std::vector<Configuration> configurations{};
};

/// One function a problem, each in a file of its own: together they hold hundreds of solvers to compile.
Problem axis_aligned();
Problem vortex();
Problem cavity();
Problem radial_cavity();
Problem kirsch();
Problem sod();
Problem axial_bar();
Problem space();
Problem gas();

/// All of them, in the order of the chart.
std::vector<Problem> all_problems();

/// The one of that name. Throws mpm::io::InputError, with the names there are.
Problem find_problem(const std::string& name);

}  // namespace accuracy_cost
