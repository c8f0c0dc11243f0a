// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <problems/vortex.hpp>

namespace accuracy_cost {

Problem vortex() {
  using Options = mpm::problems::VortexOptions;
  const auto run = []<class Shape, class Integrator, class Scalar>(const Options& options, Integrator integrator) {
    return mpm::problems::vortex<Shape, Integrator, Scalar>(options, integrator);
  };
  Methods methods(std::vector<Options>{{}, {.amplitude = .8}}, {{2, .2}, {2, .1}, {3, .2}}, run);
  methods.shape<mpm::Linear>().shape<mpm::Ugimp>().shape<mpm::Cpgimp>().shape<mpm::QuadraticBspline>();
  methods.shape<mpm::CubicBspline>().shape<mpm::Cpdi>().shape<mpm::CpdiQuad>();
  return {.name = "vortex",
          .title = "Generalized vortex, A 1: displacement over one period, L2",
          .variants = {"amplitude 1", "amplitude .8"},
          .quick = {4, 8, 12, 18},
          .full = {4, 8, 12, 18, 27, 40},
          .configurations = methods.take()};
}

}  // namespace accuracy_cost
