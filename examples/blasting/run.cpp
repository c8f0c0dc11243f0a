// SPDX-License-Identifier: MIT
#include "run.hpp"
#include "laws.hpp"
#ifdef _OPENMP
#include <omp.h>
#endif

namespace blasting {

#ifdef _OPENMP
void use_threads(int threads) {
  if (threads > 0) omp_set_num_threads(threads);
}
int threads_in_use() {
  return omp_get_max_threads();
}
#else
void use_threads(int) {}
int threads_in_use() {
  return 1;
}
#endif

void run(const Scene& scene, const Options& options) {
  if (scene.rock.law == RockLaw::elastic) return run_with<ElasticRock>(scene, options);
  if (scene.rock.tensile.law == TensileLaw::none) return run_with<CrushingRock>(scene, options);
  run_with<CrackingRock>(scene, options);
}

}  // namespace blasting
