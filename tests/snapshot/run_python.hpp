// SPDX-License-Identifier: MIT
#pragma once
#include <sys/wait.h>
#include <unistd.h>
#include <filesystem>
#include <string>

/// Runs a Python script of this folder on `argument`; its exit status. 77 means: what it needs is not installed.
inline int run_python(const std::string& script, const std::filesystem::path& argument) {
  const auto program = std::filesystem::path(MPM_TEST_SCRIPTS) / script;
  const pid_t child = fork();
  if (child == 0) {
    execl(MPM_VTK_PYTHON, MPM_VTK_PYTHON, program.c_str(), argument.c_str(), static_cast<char*>(nullptr));
    _exit(77);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
