// SPDX-License-Identifier: MIT
#include "command_line.hpp"
#include <mpm/io/info_file.hpp>
#include <algorithm>
#include <boost/program_options.hpp>
#include <iomanip>
#include <ostream>
#include <program/output_folder.hpp>
#include <system_error>

namespace blasting {
namespace {

namespace po = boost::program_options;
using mpm::io::InputError;
using mpm::io::shown;

po::options_description description(Options& o, std::string& threads, std::string& output) {
  po::options_description all("Options");
  auto add = all.add_options();
  add("scene", po::value(&o.scene)->value_name("FILE"), "scene file (none: the default scene, listed below)");
  add("set", po::value(&o.set)->value_name("KEY=VALUE"), "one key over the scene; repeatable");
  add("threads", po::value(&threads)->value_name("N"), "number of threads (none: all the machine offers)");
  add("output", po::value(&output)->value_name("DIR"), "folder of the results (none: ./out)");
  add("dry-run", po::bool_switch(&o.dry_run), "say what the run would cost, then stop");
  add("force", po::bool_switch(&o.force), "write over an earlier result");
  add("help", po::bool_switch(&o.help), "print this and stop");
  return all;
}

int thread_count(const std::string& text) {
  constexpr int most = 1024;
  try {
    const int n = mpm::io::parse_integer(text);
    if (n >= 1 && n <= most) return n;
  } catch (const InputError&) {
  }
  throw InputError("--threads = " + shown(text) + ": expected a whole number from 1 to " + std::to_string(most));
}

mpm::io::Entry assignment(const std::string& text) {
  const auto equals = text.find('=');
  const std::string key(mpm::io::trimmed(text.substr(0, equals)));
  if (equals == text.npos || key.empty()) throw InputError("--set " + shown(text) + ": expected key=value");
  return {key, text.substr(equals + 1), "--set"};
}

}  // namespace

Options parse(int argc, const char* const* argv) {
  Options options;
  std::string threads, output;
  try {
    // No guessing: `--out` must not silently mean `--output`, nor a later option change what it means.
    const auto style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    const auto all = description(options, threads, output);
    const auto parsed = po::command_line_parser(argc, argv).options(all).style(style).run();
    for (const auto& option : parsed.options)
      if (option.string_key.empty())
        throw InputError("stray word " + shown(option.value.front()) + ": a scene file is given as --scene FILE");
    po::variables_map values;
    po::store(parsed, values);
    po::notify(values);
    if (values.count("scene") != 0 && options.scene.empty()) throw InputError("--scene needs the name of a file");
    if (values.count("output") != 0 && output.empty()) throw InputError("--output needs the name of a folder");
    if (values.count("threads") != 0) options.threads = thread_count(threads);
    if (values.count("output") != 0) options.output = output;
  } catch (const po::error& error) {
    throw InputError(std::string(error.what()) + "; --help lists the options");
  }
  return options;
}

void print_help(std::ostream& out) {
  Options options;
  std::string threads, output;
  out << "blasting: holes blasted in pre-stressed rock.\n\n" << description(options, threads, output);
  Scene scene;
  const auto all = parameters(scene);
  std::size_t name_width = 0, value_width = 0;
  const auto shown_default = [](const mpm::io::Parameter& p) {
    const std::string value = mpm::io::value_text(p);
    return value.empty() ? "preset" + (p.unit.empty() ? "" : " (" + p.unit + ")") : value;
  };
  for (const auto& parameter : all) {
    name_width = std::max(name_width, parameter.name.size() + 2);
    value_width = std::max(value_width, shown_default(parameter).size() + 2);
  }
  out << "\nKeys of a scene, their defaults (preset: set by charge.preset or rock.preset) and meanings.\n"
         "A value may carry a unit (5 mm, 2.66 g/cm^3, 40 MPa, 300 us); a bare number is SI.\n\n";
  out << std::left;
  for (const auto& parameter : all) {
    const std::string range = mpm::io::range_text(parameter);
    out << "  " << std::setw(static_cast<int>(name_width)) << parameter.name << std::setw(static_cast<int>(value_width))
        << shown_default(parameter) << parameter.text << (range.empty() ? "" : " [" + range + "]") << '\n';
  }
}

Scene read_scene(const Options& options) {
  Scene scene;
  const auto all = parameters(scene);
  if (!options.scene.empty()) mpm::io::assign_all(all, mpm::io::read_info(options.scene));
  std::vector<mpm::io::Entry> over;
  for (const auto& text : options.set) over.push_back(assignment(text));
  mpm::io::assign_all(all, over);
  return scene;
}

void prepare_output(const std::filesystem::path& folder, bool force) {
  program::prepare_output(folder, force);
  std::error_code error;
  std::filesystem::remove(folder / "summary.json", error);
}

}  // namespace blasting
