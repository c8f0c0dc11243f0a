// SPDX-License-Identifier: MIT
#include "threads.hpp"
#ifdef _OPENMP
#include <omp.h>
#endif

namespace program {

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

}  // namespace program
