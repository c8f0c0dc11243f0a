// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <iosfwd>

namespace paper {

/// What the command line asks for.
struct Options {
  std::filesystem::path output{"paper"};  ///< folder of the report
  bool quick = false;                     ///< on cells and particles of twice the paper's size
  int threads = 0;                        ///< 0: as many as the machine offers
  bool help = false;                      ///< print the help and stop
};

/// Reads the command line. Throws mpm::io::InputError: unknown option, missing or bad value, stray word.
Options parse(int argc, const char* const* argv);
void print_help(std::ostream& out);

/// Makes the folder of the report, or finds one that this program began at the same size. Throws mpm::io::InputError,
/// with nothing touched, if it holds anything else or cannot be written.
void prepare_folder(const Options& options);

}  // namespace paper
