// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include "table.hpp"

namespace accuracy_cost {

/// Draws the rows of one problem into a PNG file: error against cost, both logarithmic, a line a method, shapes told
/// apart by colour and integrators by the points; over them the front. False if gnuplot is missing.
bool draw(const Table& rows, const std::string& title, const std::filesystem::path& png);

}  // namespace accuracy_cost
