// SPDX-License-Identifier: MIT
#include "command_line.hpp"
#include "laws.hpp"
#include "run.hpp"
#include "scene.hpp"
#include <mpm/error.hpp>
#include <cstdio>
#include <iostream>

// One hole blasted in pre-stressed rock (Xiao et al. 2024, Processes 12, 1048). Exit codes: 0 done, 1 the run failed, 2
// bad input, found before any work.
int main(int argc, char** argv) {
  try {
    const auto options = blasting::parse(argc, argv);
    if (options.help) return blasting::print_help(std::cout), 0;
    const auto scene = blasting::read_scene(options);
    blasting::validate(scene);
    blasting::check_laws(scene);
    blasting::use_threads(options.threads);
    if (!options.dry_run) {
      blasting::prepare_output(options.output, options.force);
      blasting::write_scene(scene, options.output / "scene.info");
    }
    blasting::run(scene, options);
    return 0;
  } catch (const mpm::io::InputError& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
