// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>

namespace mpm {

/// A run that cannot go on: the message names body, particle, position, time and step, and what a user can do.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mpm
