// SPDX-License-Identifier: MIT
#include <program/exit_code.hpp>
#include <program/threads.hpp>
#include <iostream>
#include "programs.hpp"

// Speed against accuracy. Exit code 1 also where the budget was missed.
int main(int argc, char** argv) {
  program::use_threads(1);  // costs are core-seconds
  return program::exit_code([&] {
    using accuracy_cost::Options;
    const Options options = accuracy_cost::parse(argc, argv);
    switch (options.command) {
      case Options::Command::help:
        accuracy_cost::print_help(std::cout);
        break;
      case Options::Command::chart:
        accuracy_cost::chart(options);
        break;
      case Options::Command::tune:
        return accuracy_cost::tune(options) ? 0 : 1;
    }
    return 0;
  });
}
