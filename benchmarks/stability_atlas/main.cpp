// SPDX-License-Identifier: MIT
#include <mpm/io/text.hpp>
#include <mpm/io/units.hpp>
#include <program/exit_code.hpp>
#include <program/output_folder.hpp>
#include <boost/program_options.hpp>
#include <chrono>
#include <cstdio>
#include <iostream>
#include "limits.hpp"
#include "sheets.hpp"

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace mpm::atlas;

struct Options {
  bool quick = false, force = false;
  std::string output = "atlas";
};

/// False if help was asked for and given. Throws mpm::io::InputError.
bool parse(int argc, char** argv, Options& options) {
  po::options_description all("Where each method stands and where it falls: pictures, atlas.csv and atlas.md");
  auto add = all.add_options();
  add("output", po::value(&options.output)->value_name("DIR"), "folder of the results (none: ./atlas)");
  add("quick", po::bool_switch(&options.quick), "coarser: about a minute");
  add("force", po::bool_switch(&options.force), "write over an earlier one");
  add("help", "print this and stop");
  try {
    const auto style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    const auto parsed = po::command_line_parser(argc, argv).options(all).style(style).run();
    for (const auto& option : parsed.options)
      if (option.string_key.empty())
        throw mpm::io::InputError("stray word " + mpm::io::shown(option.value.front()) + "; --help lists the options");
    po::variables_map values;
    po::store(parsed, values);
    po::notify(values);
    if (values.count("help") != 0) return std::cout << all, false;
  } catch (const po::error& error) {
    throw mpm::io::InputError(std::string(error.what()) + "; --help lists the options");
  }
  if (options.output.empty()) throw mpm::io::InputError("--output needs the name of a folder");
  return true;
}

void run(const Options& options) {
  const fs::path folder = options.output;
  program::prepare_output(folder, options.force);
  const auto begin = std::chrono::steady_clock::now();
  const auto say = [&](const std::string& what) {
    std::printf("%5.0f s  %s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
                what.c_str());
    std::fflush(stdout);
  };
  const std::vector<Sheet (*)(bool)> makers{
      growing_amplitude, gas_in_a_box, particles_a_cell,  numerical_fracture, over_stretch,   shear_flow, spin, turn,
      locking,           bending,      struck_bar_energy, checkerboard_decay, relaxation_stop};
  std::vector<Sheet> sheets(makers.size());
#pragma omp parallel for schedule(dynamic)  // sheets side by side, each on one thread
  for (std::size_t k = 0; k < makers.size(); ++k) {
    sheets[k] = makers[k](options.quick);
#pragma omp critical
    say(sheets[k].mode);
  }
  for (const Sheet& sheet : sheets) draw(sheet, folder / (sheet.name + ".png"));
  write(sheets, folder / "atlas.csv");
  const auto all_limits = limits(options.quick);
  write(all_limits, folder / "limits.csv");
  draw(all_limits, folder / "limits.png");
  say("limits");
  const auto maps = growth_maps(options.quick);
  write(maps, folder / "growth.csv");
  draw_each(maps, folder);
  say("growth maps");
  mpm::io::replace_file(folder / "atlas.md", markdown(sheets) + "\nSteps of blocks of two particles a cell edge:\n\n" +
                                                 markdown(all_limits));
  std::printf("results in %s\n", folder.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  return program::exit_code([&] {
    Options options;
    if (parse(argc, argv, options)) run(options);
    return 0;
  });
}
