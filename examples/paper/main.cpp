// SPDX-License-Identifier: MIT
#include "options.hpp"
#include "report.hpp"
#include <blasting/run.hpp>
#include <program/exit_code.hpp>
#include <program/threads.hpp>
#include <cstdio>
#include <iostream>

// The figures and statements of Xiao et al. 2024, Processes 12, 1048, made again.
int main(int argc, char** argv) {
  return program::exit_code([&] {
    const auto options = paper::parse(argc, argv);
    if (options.help) {
      paper::print_help(std::cout);
      return 0;
    }
    paper::prepare_folder(options);
    program::use_threads(options.threads);
    paper::Report report{options.output, options.quick};
    for (const auto& part : {paper::kirsch_curves, paper::initial_stress, paper::cavity_histories, paper::marble_slab,
                             paper::twelve_blasts, paper::energy_ledger, paper::rock_readings, paper::economy,
                             paper::objectivity, paper::hole_pairs}) {
      part(report);
      report.write();
    }
    std::printf("report in %s\n", (options.output / "index.html").c_str());
    return 0;
  });
}
