// SPDX-License-Identifier: MIT
#include "case.hpp"
#include <blasting/command_line.hpp>
#include <blasting/laws.hpp>
#include <blasting/run.hpp>
#include <mpm/error.hpp>
#include <mpm/io/info_file.hpp>
#include <boost/property_tree/json_parser.hpp>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace paper {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string text_of(blasting::Scene scene) {
  std::string text;
  for (const auto& parameter : blasting::parameters(scene))
    text += parameter.name + '=' + mpm::io::value_text(parameter) + '\n';
  return text;
}

/// Whether the folder holds a run of this very scene.
bool same_scene(const blasting::Scene& scene, const fs::path& folder) {
  if (!fs::exists(folder / "scene.info")) return false;
  try {
    blasting::Scene earlier;
    mpm::io::assign_all(blasting::parameters(earlier), mpm::io::read_info((folder / "scene.info").string()));
    return text_of(earlier) == text_of(scene);
  } catch (const mpm::io::InputError&) {
    return false;  // a run of another version
  }
}

/// Reads what the folder holds; false if the run has neither ended nor failed.
bool read_result(Blast& blast) {
  blast.problem = contents(blast.folder / "problem.txt");
  if (!blast.problem.empty()) return true;
  if (!fs::exists(blast.folder / "summary.json")) return false;
  read_json((blast.folder / "summary.json").string(), blast.summary);
  return blast.summary.get<bool>("completed", false);
}

}  // namespace

double Blast::number(const std::string& key) const {
  return completed() ? summary.get<double>(key) : std::numeric_limits<double>::quiet_NaN();
}

Columns Blast::table(const std::string& file) const {
  return read_columns(folder / file);
}

Columns read_columns(const fs::path& csv) {
  std::ifstream in(csv);
  std::string line, cell;
  if (!std::getline(in, line)) throw std::runtime_error(csv.string() + ": cannot be read");
  std::vector<std::string> names;
  for (std::istringstream header(line); std::getline(header, cell, ',');)
    names.push_back(cell.substr(0, cell.rfind(" [")));
  Columns columns;
  while (std::getline(in, line)) {
    std::istringstream row(line);
    for (const auto& name : names) {
      if (!std::getline(row, cell, ',')) throw std::runtime_error(csv.string() + ": a row is cut short");
      columns[name].push_back(std::stod(cell));
    }
  }
  return columns;
}

Blast run(const Case& one, const fs::path& parent) {
  blasting::validate(one.scene);
  blasting::check_laws(one.scene);
  Blast blast{.scene = one.scene, .folder = parent / one.name};
  if (same_scene(one.scene, blast.folder) && read_result(blast)) return blast;
  blasting::prepare_output(blast.folder, true);
  fs::remove(blast.folder / "problem.txt");
  blasting::write_scene(one.scene, blast.folder / "scene.info");
  std::printf("%s: ", one.name.c_str());
  std::fflush(stdout);
  blasting::Options options;
  options.output = blast.folder;
  try {
    blasting::run(one.scene, options);
  } catch (const mpm::Error& error) {
    std::printf("%s\n", error.what());
    std::ofstream(blast.folder / "problem.txt") << error.what();
  }
  if (!read_result(blast)) throw std::runtime_error(blast.folder.string() + ": the run has left no result");
  return blast;
}

}  // namespace paper
