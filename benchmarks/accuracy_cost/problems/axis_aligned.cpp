// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <problems/axis_aligned.hpp>

namespace accuracy_cost {

Problem axis_aligned() {
  using Options = mpm::problems::AxisAlignedOptions;
  const auto run = []<class Shape, class Integrator, class Scalar>(const Options& options, Integrator integrator) {
    return mpm::problems::axis_aligned<2, Shape, Integrator, Scalar>(options, integrator);
  };
  Methods methods(std::vector<Options>{{}, {.amplitude = .04}, {.amplitude = .07}}, {{2, .5}, {2, .25}, {3, .5}}, run);
  methods.shape<mpm::Linear>().shape<mpm::Ugimp>().shape<mpm::Cpgimp>().shape<mpm::QuadraticBspline>();
  methods.shape<mpm::CubicBspline>().shape<mpm::Cpdi>().shape<mpm::CpdiQuad>();
  return {.name = "axis_aligned",
          .title = "Axis-aligned manufactured solution, plane, A .05: displacement over one period, L2",
          .variants = {"amplitude .05", "amplitude .04", "amplitude .07"},
          .quick = {4, 8, 16},
          .full = {4, 8, 16, 32},
          .configurations = methods.take()};
}

}  // namespace accuracy_cost
