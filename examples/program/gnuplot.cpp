// SPDX-License-Identifier: MIT
#include "gnuplot.hpp"
#include <mpm/io/text.hpp>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace program {
namespace {

/// Starts `gnuplot -d script` in `folder`, its messages in a file there, and waits. The error of the start, or 0 and
/// the status it ended with. No shell in between.
int run_in(const std::filesystem::path& folder, int& status) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "messages", O_WRONLY | O_CREAT, 0600);
  std::string program = "gnuplot", no_user_settings = "-d", script = "script";
  char* arguments[] = {program.data(), no_user_settings.data(), script.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error) return error;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return 0;
}

void warn_once() {
  static const bool warned = [] {
    std::cerr << "warning: gnuplot is not on the PATH: no pictures are drawn\n";
    return true;
  }();
  static_cast<void>(warned);
}

}  // namespace

std::string gnuplot_string(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "'";
}

Gnuplot::Gnuplot(std::filesystem::path png) : png_(std::move(png)) {
  std::string name = (png_.parent_path() / ".picture-XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw std::runtime_error(png_.string() + ": mkdtemp: " + std::generic_category().message(errno));
  folder_ = std::filesystem::absolute(name);
}

Gnuplot::~Gnuplot() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

bool Gnuplot::draw(int width, int height, const std::string& script) const {
  mpm::io::replace_file(folder_ / "script", "set encoding utf8\nset terminal pngcairo noenhanced font 'Sans,15' size " +
                                                std::to_string(width) + "," + std::to_string(height) +
                                                "\nset output 'picture.png'\n" + script);
  int status = 0;
  const int error = run_in(folder_, status);
  if (error == ENOENT) {
    warn_once();
    return false;
  }
  if (error) throw std::runtime_error(png_.string() + ": gnuplot: " + std::generic_category().message(error));
  if (status != 0 || !std::filesystem::exists(folder_ / "picture.png")) {
    std::ifstream messages(folder_ / "messages");
    throw std::runtime_error(png_.string() +
                             ": gnuplot failed: " + std::string(std::istreambuf_iterator<char>(messages), {}));
  }
  std::filesystem::rename(folder_ / "picture.png", png_);
  return true;
}

}  // namespace program
