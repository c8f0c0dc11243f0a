// SPDX-License-Identifier: MIT
#include "run.hpp"
#include "laws.hpp"
#include "stages.hpp"

namespace blasting {

void run(const Scene& scene, const Options& options) {
  const auto& rock = scene.rock;
  if (rock.law == RockLaw::elastic) return run_with<Rock<ElasticRock>>(scene, options);
  if (rock.tensile.law == TensileLaw::none) return run_with<Rock<CrushingRock>>(scene, options);
  if (rock.shape == RockShape::ugimp) return run_with<Rock<CrackingRock, Ugimp>>(scene, options);
  if (scene.step.precision != Precision::double_) return run_with<Rock<CrackingRock, CpdiQuad, float>>(scene, options);
  run_with<Rock<CrackingRock>>(scene, options);
}

}  // namespace blasting
