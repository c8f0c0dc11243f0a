// SPDX-License-Identifier: MIT
#pragma once
#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/wait.h>

/// A fresh folder for one test, removed with all it holds. Its name has a blank and both quotes, as a user's may.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "mpm \"it's\" XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Number of files whose name ends in `ending`.
inline int count_files(const std::filesystem::path& folder, const std::string& ending) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    count += entry.path().string().ends_with(ending);
  return count;
}

/// Runs a Python script of this folder on `argument`; its exit status. 77 means: what it needs is not installed.
inline int run_python(const std::string& script, const std::filesystem::path& argument) {
  const std::string program = std::string(MPM_TEST_SCRIPTS) + "/" + script;
  const pid_t child = fork();
  if (child == 0) {
    execl(MPM_VTK_PYTHON, MPM_VTK_PYTHON, program.c_str(), argument.c_str(), static_cast<char*>(nullptr));
    _exit(77);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
