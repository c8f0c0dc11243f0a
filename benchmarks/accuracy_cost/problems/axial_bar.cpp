// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <problems/axial_bar.hpp>

namespace accuracy_cost {

Problem axial_bar() {
  using Options = mpm::problems::AxialBarOptions;
  const auto run = []<class Shape, class Integrator, class Scalar>(const Options& options, Integrator integrator) {
    return mpm::problems::axial_bar<Shape, Integrator, Scalar>(options, integrator);
  };
  // An eighth of a period past the zero, where a loss of amplitude shows beside an error of phase.
  Methods methods(std::vector<Options>{{.periods = 5.125}, {.periods = 4.125}, {.periods = 6.125}},
                  {{2, .8}, {2, .4}, {4, .8}}, run);
  methods.shape<mpm::Linear>().shape<mpm::Ugimp>().shape<mpm::Cpgimp>();
  methods.shape<mpm::QuadraticBspline>().shape<mpm::CubicBspline>().shape<mpm::Cpdi>();
  return {.name = "bar",
          .title = "Axial bar: displacement after 5 1/8 periods, L2",
          .variants = {"5 1/8 periods", "4 1/8 periods", "6 1/8 periods"},
          .quick = {5, 10, 20, 40},
          .full = {5, 10, 20, 40, 80, 160},
          .configurations = methods.take()};
}

}  // namespace accuracy_cost
