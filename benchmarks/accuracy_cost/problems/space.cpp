// SPDX-License-Identifier: MIT
#include <accuracy_cost/problem.hpp>
#include <problems/boxed_cavity.hpp>

namespace accuracy_cost {

namespace problems = mpm::problems;

// One question, modelled in ever more of space.
Problem space() {
  using Options = problems::CavityOptions;
  using Run = problems::CavityOutcome (*)(Options);
  const std::vector<Options> variants{{.history_from = 1}, {.side = 18, .history_from = 1}};
  Problem problem{.name = "space",
                  .title = "Cavity wave in as much of space as is modelled: peak hoop stress at 2 and 5 radii",
                  .variants = {"block of 15 radii", "block of 18 radii"},
                  .quick = {2, 3},
                  .full = {2, 3, 4, 6, 8}};
  const auto add = [&](const char* scene, const char* shape, Run run) {
    const auto largest_error = [variants, run](int cells, std::size_t variant) {
      Options options = variants.at(variant);
      options.cells = cells;
      const auto outcome = run(options);
      problems::Outcome result = outcome;
      result.error = std::max(std::abs(outcome.peak[0]), std::abs(outcome.peak[1]));
      return result;
    };
    problem.configurations.push_back({{shape, "USL", "FLIP", "double", 2, .8, scene}, true, largest_error});
  };
  add("along the radius", "Ugimp", [](Options o) { return problems::radial_cavity<mpm::Ugimp>(o); });
  add("quarter plane", "CpdiQuad", [](Options o) { return problems::cavity(o); });
  add("full plane", "CpdiQuad", [](Options o) {
    o.model = problems::Model::full;
    return problems::cavity(o);
  });
  add("quarter plane of boxes", "Ugimp", [](Options o) { return problems::boxed_cavity<mpm::PlaneStrain<>>(o); });
  add("quarter slice of boxes", "Ugimp", [](Options o) { return problems::boxed_cavity<mpm::Spatial<>>(o); });
  return problem;
}

}  // namespace accuracy_cost
