// SPDX-License-Identifier: MIT
#include "options.hpp"
#include "report.hpp"
#include <blasting/run.hpp>
#include <mpm/io/units.hpp>
#include <cstdio>
#include <iostream>

// The figures and statements of Xiao et al. 2024, Processes 12, 1048, made again. Exit codes: 0 done, 1 a run failed, 2
// bad input, found before any work.
int main(int argc, char** argv) {
  try {
    const auto options = paper::parse(argc, argv);
    if (options.help) return paper::print_help(std::cout), 0;
    paper::prepare_folder(options);
    blasting::use_threads(options.threads);
    paper::Report front{options.output, options.quick}, report{options.output, options.quick};
    paper::kirsch_curves(report);
    paper::initial_stress(report);
    paper::cavity_histories(report);
    paper::marble_slab(report);
    paper::energy_ledger(report);
    paper::hole_pairs(report);
    paper::objectivity(report);
    paper::rock_readings(report);
    paper::economy(report);
    front.findings = report.findings;
    paper::twelve_blasts(front);
    front.page.append(report.page);
    front.page.write(options.output,
                     std::string("Rock blasting in deep ground") + (options.quick ? " (quick: cells of 20 mm)" : ""));
    std::printf("report in %s\n", (options.output / "index.html").c_str());
    return 0;
  } catch (const mpm::io::InputError& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
