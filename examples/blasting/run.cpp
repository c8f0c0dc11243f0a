// SPDX-License-Identifier: MIT
#include "run.hpp"
#include "laws.hpp"

namespace blasting {

void run(const Scene& scene, const Options& options) {
  if (scene.rock.law == RockLaw::elastic) return run_with<ElasticRock>(scene, options);
  if (scene.rock.tensile.law == TensileLaw::none) return run_with<CrushingRock>(scene, options);
  run_with<CrackingRock>(scene, options);
}

}  // namespace blasting
