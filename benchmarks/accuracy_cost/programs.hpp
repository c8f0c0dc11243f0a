// SPDX-License-Identifier: MIT
#pragma once
#include "command_line.hpp"

namespace accuracy_cost {

/// The command `chart`.
void chart(const Options& options);

/// The command `tune`. False if the budget was not kept.
bool tune(const Options& options);

}  // namespace accuracy_cost
