// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/io/units.hpp>
#include <cstdio>
#include <exception>

namespace program {

/// The exit code of a program whose work is `work()`: what that returns, or after one line on stderr 2 for bad input
/// (mpm::io::InputError, to be found before any work), 1 for any other failure.
template <class Work>
int exit_code(const Work& work) {
  try {
    return work();
  } catch (const mpm::io::InputError& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}

}  // namespace program
