// SPDX-License-Identifier: MIT
#include "output_folder.hpp"
#include <mpm/io/units.hpp>
#include <fstream>
#include <string>
#include <system_error>

namespace program {

void prepare_output(const std::filesystem::path& folder, bool force) {
  namespace fs = std::filesystem;
  using mpm::io::InputError;
  const std::string name = "--output " + mpm::io::shown(folder.string());
  const InputError unusable(name + ": cannot be written, check the path and its permissions");
  std::error_code error;
  if (fs::exists(folder, error)) {
    if (!fs::is_directory(folder, error)) throw InputError(name + ": is not a folder, name another");
    const bool empty = fs::is_empty(folder, error);
    if (error) throw unusable;
    if (!empty && !force)
      throw InputError(name + ": holds an earlier result or other files, name another or add --force to write over it");
  }
  fs::create_directories(folder, error);
  const fs::path probe = folder / ".write_test";
  if (error || !std::ofstream(probe)) throw unusable;
  fs::remove(probe, error);
}

}  // namespace program
