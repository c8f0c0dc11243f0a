// SPDX-License-Identifier: MIT
#include "options.hpp"
#include <mpm/io/units.hpp>
#include <program/output_folder.hpp>
#include <boost/program_options.hpp>
#include <fstream>
#include <ostream>
#include <string>

namespace paper {
namespace {

namespace po = boost::program_options;
using mpm::io::InputError;

po::options_description description(Options& o, std::string& output) {
  po::options_description all("Options");
  auto add = all.add_options();
  add("output", po::value(&output)->value_name("DIR"),
      "folder of the report (none: ./paper); one begun before is gone on with");
  add("quick", po::bool_switch(&o.quick), "cells and particles of twice the paper's size: minutes");
  add("threads", po::value(&o.threads)->value_name("N"), "number of threads (none: all the machine offers)");
  add("help", po::bool_switch(&o.help), "print this and stop");
  return all;
}

}  // namespace

Options parse(int argc, const char* const* argv) {
  Options options;
  std::string output;
  try {
    const auto style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    const auto all = description(options, output);
    const auto parsed = po::command_line_parser(argc, argv).options(all).style(style).run();
    for (const auto& option : parsed.options)
      if (option.string_key.empty())
        throw InputError("stray word " + mpm::io::shown(option.value.front()) + "; --help lists the options");
    po::variables_map values;
    po::store(parsed, values);
    po::notify(values);
    if (values.count("output") != 0 && output.empty()) throw InputError("--output needs the name of a folder");
    if (values.count("output") != 0) options.output = output;
    if (values.count("threads") != 0 && (options.threads < 1 || options.threads > 1024))
      throw InputError("--threads = " + std::to_string(options.threads) + ": expected a whole number from 1 to 1024");
  } catch (const po::error& error) {
    throw InputError(std::string(error.what()) + "; --help lists the options");
  }
  return options;
}

void print_help(std::ostream& out) {
  Options options;
  std::string output;
  out << "paper: the figures and statements of Xiao et al. 2024 (Processes 12, 1048), made again.\n\n"
      << description(options, output);
}

void prepare_folder(const Options& options) {
  const auto mark = options.output / ".paper";
  const std::string size = options.quick ? "quick" : "full";
  std::string found;
  std::ifstream(mark) >> found;
  if (!found.empty() && found != size)
    throw InputError("--output " + mpm::io::shown(options.output.string()) + ": holds a report of the " + found +
                     " size, name another folder" + (options.quick ? "" : " or add --quick"));
  program::prepare_output(options.output, !found.empty());
  std::ofstream(mark) << size << '\n';
}

}  // namespace paper
