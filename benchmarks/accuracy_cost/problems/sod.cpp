// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <problems/sod.hpp>

namespace accuracy_cost {

Problem sod() {
  using Options = mpm::problems::SodOptions;
  const auto run = []<class Shape, class Integrator, class Scalar>(const Options& options, Integrator integrator) {
    return mpm::problems::sod<Shape, Integrator, Scalar>(options, integrator);
  };
  Methods methods(std::vector<Options>{{}, {.viscosity = {1, .1}}}, {{4, .5}, {4, .25}, {2, .5}}, run);
  methods.shape<mpm::Linear>().shape<mpm::Ugimp>().shape<mpm::Cpgimp>();
  methods.shape<mpm::QuadraticBspline>().shape<mpm::CubicBspline>().shape<mpm::Cpdi>();
  return {.name = "sod",
          .title = "Sod's shock tube: density at .2 s, L1",
          .variants = {"bulk viscosity 1.5, .06", "bulk viscosity 1, .1"},
          .quick = {25, 50, 100, 200},
          .full = {25, 50, 100, 200, 400, 800},
          .configurations = methods.take()};
}

}  // namespace accuracy_cost
