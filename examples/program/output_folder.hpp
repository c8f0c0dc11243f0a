// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace program {

/// Makes the folder that `--output` names and checks that it can be written. Throws mpm::io::InputError, with nothing
/// touched: not a folder, not writable, not empty without `force`.
void prepare_output(const std::filesystem::path& folder, bool force);

}  // namespace program
