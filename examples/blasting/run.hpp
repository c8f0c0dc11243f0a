// SPDX-License-Identifier: MIT
#pragma once
#include "command_line.hpp"
#include "scene.hpp"

namespace blasting {

/// Runs a valid scene from the in-situ stress to the end of the blast and writes its results into options.output, or
/// only says what it would cost (--dry-run). Throws mpm::Error when a stage fails; what was written stays.
void run(const Scene& scene, const Options& options);

/// The same for one kind of rock; each stands in a file of its own, to compile side by side.
template <class Rock>
void run_with(const Scene& scene, const Options& options);

}  // namespace blasting
