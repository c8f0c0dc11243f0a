// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <problems/kirsch.hpp>

namespace accuracy_cost {

// Only quadrilaterals follow the wall, and single precision does not come to rest within 1e-6: what there is to choose
// is the start, and the size.
Problem kirsch() {
  using Options = mpm::problems::KirschOptions;
  using mpm::problems::Start;
  const auto started = [](Start start, const char* from) {
    const auto run = [start]<class Shape, class Integrator, class Scalar>(Options options, Integrator integrator) {
      options.start = start;
      auto outcome = mpm::problems::kirsch<Shape, Integrator, Scalar>(options, integrator);
      outcome.error = std::max(outcome.error, outcome.worst_wall());
      return mpm::problems::Outcome(outcome);
    };
    Methods methods(std::vector<Options>{{}, {.ratio = 1}, {.ratio = 3}}, {{2, .8}, {3, .8}}, run);
    auto made = methods.template add<mpm::CpdiQuad, double>("relaxed", "adaptively", mpm::DynamicRelaxation<>{}).take();
    for (auto& configuration : made) configuration.method.scene = from;
    return made;
  };
  auto configurations = started(Start::exact, "from Kirsch");
  for (auto& c : started(Start::far_field, "from the far field")) configurations.push_back(std::move(c));
  for (auto& c : started(Start::nothing, "from no stress")) configurations.push_back(std::move(c));
  return {.name = "kirsch",
          .title = "Kirsch, k .25, quarter plane: the larger of hoop stress on the wall and stress beyond 3 radii (L2)",
          .variants = {"k .25", "k 1", "k 3"},
          .quick = {1, 2, 3},
          .full = {1, 2, 3, 4, 6, 8},
          .configurations = std::move(configurations)};
}

}  // namespace accuracy_cost
