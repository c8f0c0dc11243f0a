// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <problems/cavity.hpp>

namespace accuracy_cost {
namespace {

using Options = mpm::problems::CavityOptions;

const std::vector<std::string> variants{"block of 15 radii", "block of 18 radii"};
// No history is compared: the exact one costs more than the run.
const std::vector<Options> options_of_variants{{.history_from = 1}, {.side = 18, .history_from = 1}};
const std::vector<Setting> settings{{2, .8}, {2, .4}, {3, .8}};

}  // namespace

Problem cavity() {
  const auto run = []<class Shape, class Integrator, class Scalar>(const Options& options, Integrator integrator) {
    return mpm::problems::cavity<Shape, Integrator, Scalar>(options, integrator);
  };
  return {.name = "cavity",
          .title = "Cavity wave, quarter plane: largest error of the peak hoop stress at 2, 5 and 10 radii",
          .variants = variants,
          .quick = {2, 3},
          .full = {2, 3, 4, 6, 8},
          .configurations = Methods(options_of_variants, settings, run).shape<mpm::CpdiQuad>().take()};
}

Problem radial_cavity() {
  const auto run = []<class Shape, class Integrator, class Scalar>(const Options& options, Integrator integrator) {
    return mpm::problems::radial_cavity<Shape, Integrator, Scalar>(options, integrator);
  };
  Methods methods(options_of_variants, settings, run);
  methods.shape<mpm::Linear>().shape<mpm::Ugimp>().shape<mpm::Cpdi>();
  return {.name = "radial_cavity",
          .title = "Cavity wave, along the radius: largest error of the peak hoop stress at 2, 5 and 10 radii",
          .variants = variants,
          .quick = {2, 4, 8},
          .full = {2, 4, 8, 16, 32},
          .configurations = methods.take()};
}

}  // namespace accuracy_cost
