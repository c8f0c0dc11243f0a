// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace program {

/// A folder beside the picture to be, where gnuplot works and which goes away with this object. Inside it all names are
/// plain, so that no path of the user's ever stands in a script.
class Gnuplot {
 public:
  /// Throws std::runtime_error if the folder cannot be made.
  explicit Gnuplot(std::filesystem::path png);
  ~Gnuplot();
  Gnuplot(const Gnuplot&) = delete;
  Gnuplot& operator=(const Gnuplot&) = delete;

  /// The folder, for data that the script reads.
  const std::filesystem::path& folder() const { return folder_; }

  /// Runs a script that draws on a PNG of the given size (pixels) and puts the result in place. False, after one
  /// warning a process, if gnuplot is not on the PATH. Throws std::runtime_error with gnuplot's own words if it fails.
  bool draw(int width, int height, const std::string& script) const;

 private:
  std::filesystem::path png_;
  std::filesystem::path folder_;
};

/// `text` as a gnuplot string in which no character has a meaning of its own.
std::string gnuplot_string(std::string_view text);

}  // namespace program
