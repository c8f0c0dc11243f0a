// SPDX-License-Identifier: MIT
#include <accuracy_cost/problem.hpp>
#include <problems/charged_hole.hpp>

namespace accuracy_cost {

// One charge in one hole, with as many gas particles as one likes, and with air or nothing around the charge.
Problem gas() {
  using mpm::problems::ChargedHoleOptions;
  using mpm::problems::ChargedHoleOutcome;
  using Run = ChargedHoleOutcome (*)(const ChargedHoleOptions&);
  Problem problem{
      .name = "gas",
      .title = "Charge of 3/4 radius in its hole: peak hoop stress at 2 and 5 radii, against a/128 radially",
      .variants = {"PETN of 3/4 of the radius"},
      .quick = {2, 3, 8},
      .full = {2, 3, 4, 8, 16, 32}};
  const auto add = [&](const std::string& where, int gas_per_edge, bool air, Run run) {
    const auto against_finest = [gas_per_edge, air, run](int cells, std::size_t) {
      static const auto finest = mpm::problems::radial_charged_hole({.cells = 128});
      const auto outcome = run({.cells = double(cells), .gas_per_edge = gas_per_edge, .air = air});
      mpm::problems::Outcome result = outcome;
      result.error = outcome.error_against(finest);
      return result;
    };
    const std::string scene = where + ": " + std::to_string(gas_per_edge) + (air ? " gas and air" : " gas");
    problem.configurations.push_back({{"CpdiQuad", "MUSL", "FLIP", "double", 2, .5, scene}, true, against_finest});
  };
  for (const int gas_per_edge : {2, 4, 20})
    for (const bool air : {false, true}) add("plane", gas_per_edge, air, mpm::problems::charged_hole);
  add("radius", 4, true, mpm::problems::radial_charged_hole);
  problem.configurations.back().method.shape = "Ugimp";
  return problem;
}

}  // namespace accuracy_cost
