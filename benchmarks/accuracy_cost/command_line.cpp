// SPDX-License-Identifier: MIT
#include "command_line.hpp"
#include <mpm/io/units.hpp>
#include <boost/program_options.hpp>
#include <ostream>
#include "problem.hpp"

namespace accuracy_cost {
namespace {

namespace po = boost::program_options;
using mpm::io::InputError;
using mpm::io::shown;

/// Where the words of the command line go before they are checked.
struct Words {
  std::string error, output;
};

po::options_description description(Options& o, Words& words) {
  po::options_description all;
  auto add = all.add_options();
  const bool chart = o.command == Options::Command::chart;
  add("problem", po::value(&o.problems)->value_name("NAME"),
      chart ? "chart this one only; repeatable" : "the problem to tune for");
  if (chart) {
    add("quick", po::bool_switch(&o.quick), "fewer sizes: under three minutes");
    add("force", po::bool_switch(&o.force), "write over an earlier chart");
    add("output", po::value(&words.output)->value_name("DIR"), "folder of the results (none: ./chart)");
  } else {
    add("error", po::value(&words.error)->value_name("E"), "the largest relative error, such as 1% or 0.01");
    add("check", po::bool_switch(&o.check),
        "tune for variants the chart does not hold; say how often budgets are kept");
    add("output", po::value(&words.output)->value_name("DIR"),
        "folder of the chart to read (none: ./chart); a quick one is made where there is none");
  }
  add("help", "print this and stop");
  return all;
}

void require_tune(const Options& o, bool error_given) {
  if (o.check) {
    if (error_given) throw InputError("--check takes its own budgets: leave --error out");
    return;
  }
  if (o.problems.size() != 1) throw InputError("tune needs one --problem NAME; --help lists them");
  if (!error_given) throw InputError("tune needs --error E, such as --error 1%");
}

}  // namespace

double parse_share(const std::string& text) {
  std::string_view digits = mpm::io::trimmed(text);
  const bool per_cent = digits.ends_with('%');
  if (per_cent) digits = mpm::io::trimmed(digits.substr(0, digits.size() - 1));
  try {
    const double share = mpm::io::parse_quantity(digits, "") / (per_cent ? 100 : 1);
    if (share > 0 && share < 1) return share;
  } catch (const InputError&) {
  }
  throw InputError("--error " + shown(text) + ": expected a share above 0 and below 100 %, such as 1% or 0.01");
}

Options parse(int argc, const char* const* argv) {
  Options options;
  const std::string command = argc > 1 ? argv[1] : "--help";
  if (command == "--help") return options;
  if (command != "chart" && command != "tune")
    throw InputError(shown(command) + ": expected chart or tune; --help says more");
  options.command = command == "chart" ? Options::Command::chart : Options::Command::tune;
  Words words;
  try {
    const auto style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    const auto all = description(options, words);
    const auto parsed = po::command_line_parser(argc - 1, argv + 1).options(all).style(style).run();
    for (const auto& option : parsed.options)
      if (option.string_key.empty()) throw InputError("stray word " + shown(option.value.front()));
    po::variables_map values;
    po::store(parsed, values);
    po::notify(values);
    if (values.count("help") != 0) return Options{};
    if (values.count("error") != 0) options.error = parse_share(words.error);
    if (values.count("output") != 0) options.output = words.output;
    if (options.output.empty()) throw InputError("--output needs the name of a folder");
    for (const auto& name : options.problems) find_problem(name);
    if (options.command == Options::Command::tune) require_tune(options, values.count("error") != 0);
  } catch (const po::error& error) {
    throw InputError(std::string(error.what()) + "; --help lists the options");
  }
  return options;
}

void print_help(std::ostream& out) {
  Options chart, tune;
  chart.command = Options::Command::chart, tune.command = Options::Command::tune;
  Words words;
  out << "Speed against accuracy of the method's parts, on problems with exact solutions.\n\n"
         "chart: runs problems x methods x sizes on one thread; writes chart.csv, a picture a problem, and front.md,\n"
         "the methods that none beats in both.\n"
      << description(chart, words)
      << "\ntune: names the cheapest method and size of the chart that keeps an error, runs it, and says its true "
         "error.\n"
      << description(tune, words) << "\nProblems:\n";
  for (const Problem& problem : all_problems()) out << "  " << problem.name << ": " << problem.title << '\n';
}

}  // namespace accuracy_cost
