// SPDX-License-Identifier: MIT
#pragma once

namespace program {

/// Lets the steps use so many threads; 0 leaves it to OpenMP. Without OpenMP there is one.
void use_threads(int threads);
/// How many they use.
int threads_in_use();

}  // namespace program
