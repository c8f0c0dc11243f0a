// SPDX-License-Identifier: MIT
#pragma once
#include "scene.hpp"
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace blasting {

/// What the command line asks for; the member initialisers are what holds without an option.
struct Options {
  std::string scene;                    ///< scene file; empty: the default scene
  std::vector<std::string> set;         ///< "key=value" over the scene, in the order given
  int threads = 0;                      ///< 0: as many as the machine offers
  std::filesystem::path output{"out"};  ///< folder of the results
  bool dry_run = false;                 ///< count particles, bytes and steps, then stop
  bool force = false;                   ///< write over an earlier result
  bool help = false;                    ///< print the help and stop
};

/// Reads the command line. Throws mpm::io::InputError: unknown option, missing or bad value, stray word.
Options parse(int argc, const char* const* argv);

/// Prints the options and, from the one list, every key with its default, unit, meaning and valid values.
void print_help(std::ostream& out);

/// The default scene, overridden by the scene file, overridden by `--set`. Does not `validate`. Throws
/// mpm::io::InputError as reading does; a key may stand once in the file and once among the `--set`.
Scene read_scene(const Options& options);

/// Makes the folder of the results and checks that it can be written. With `force` an earlier result's `summary.json`
/// is removed, so that a run cut short does not pass for complete; the rest is written over as the run goes. Throws
/// mpm::io::InputError, with nothing touched: not a folder, not writable, not empty without `force`.
void prepare_output(const std::filesystem::path& folder, bool force);

}  // namespace blasting
