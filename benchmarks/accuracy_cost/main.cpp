// SPDX-License-Identifier: MIT
#include <mpm/io/units.hpp>
#include <cstdio>
#include <iostream>
#include "programs.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

// Speed against accuracy. Exit codes: 0 done, 1 the run failed or the budget was missed, 2 bad input, found before any
// work.
int main(int argc, char** argv) {
#ifdef _OPENMP
  omp_set_num_threads(1);  // costs are core-seconds
#endif
  using accuracy_cost::Options;
  try {
    const Options options = accuracy_cost::parse(argc, argv);
    switch (options.command) {
      case Options::Command::help:
        return accuracy_cost::print_help(std::cout), 0;
      case Options::Command::chart:
        return accuracy_cost::chart(options), 0;
      case Options::Command::tune:
        return accuracy_cost::tune(options) ? 0 : 1;
    }
  } catch (const mpm::io::InputError& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
