// SPDX-License-Identifier: MIT
#include "command_line.hpp"
#include "laws.hpp"
#include "run.hpp"
#include "scene.hpp"
#include <program/exit_code.hpp>
#include <program/threads.hpp>
#include <iostream>

// One hole blasted in pre-stressed rock (Xiao et al. 2024, Processes 12, 1048).
int main(int argc, char** argv) {
  return program::exit_code([&] {
    const auto options = blasting::parse(argc, argv);
    if (options.help) {
      blasting::print_help(std::cout);
      return 0;
    }
    const auto scene = blasting::read_scene(options);
    blasting::validate(scene);
    blasting::check_laws(scene);
    program::use_threads(options.threads);
    if (!options.dry_run) {
      blasting::prepare_output(options.output, options.force);
      blasting::write_scene(scene, options.output / "scene.info");
    }
    blasting::run(scene, options);
    return 0;
  });
}
