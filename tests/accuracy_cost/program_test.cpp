// SPDX-License-Identifier: MIT
#include <snapshot/temporary_folder.hpp>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <cstdlib>
#include <string>

// The program as a user meets it: help, and bad input refused with exit code 2 and one line that names the culprit.
namespace {

class Program : public testing::Test {
 protected:
  /// The exit code; what it printed goes to `out` and `error`. `arguments` go through the shell.
  int run(const std::string& arguments) {
    const auto in = [&](const char* name) { return "\"$F/" + std::string(name) + '"'; };
    setenv("F", folder.path().c_str(), 1);
    const std::string command =
        "timeout 60 '" MPM_ACCURACY_COST_PROGRAM "' " + arguments + " >" + in("out") + " 2>" + in("error");
    const int status = std::system(command.c_str());
    out = content(folder / "out"), error = content(folder / "error");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  void expect_refused(const std::string& arguments, const std::string& word) {
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_EQ(out, "") << arguments;
    EXPECT_TRUE(error.starts_with("error: ")) << error;
    EXPECT_EQ(error.find('\n'), error.size() - 1) << error;
    EXPECT_NE(error.find(word), std::string::npos) << arguments << ": no " << word << " in: " << error;
  }

  TemporaryFolder folder;
  std::string out, error;
};

TEST_F(Program, HelpNamesCommandsAndProblems) {
  EXPECT_EQ(run("--help"), 0);
  for (const char* word : {"chart", "tune", "--quick", "--check", "bar", "cavity: Wave from a round hole"})
    EXPECT_NE(out.find(word), std::string::npos) << word;
}

TEST_F(Program, RefusesWhatItCannotRead) {
  expect_refused("dance", "dance");
  expect_refused("chart --fast", "--fast");
  expect_refused("chart stray", "stray");
  expect_refused("chart --problem couette", "couette");
  expect_refused("chart --output ''", "--output");
  expect_refused("tune --error 1%", "--problem");
  expect_refused("tune --problem bar", "--error");
  expect_refused("tune --check --error 1%", "--check");
  for (const std::string share : {"one", "1%%", "0", "-1%", "100%", "nan", "5 mm"})
    expect_refused("tune --problem bar --error '" + share + "'", "--error");
}

TEST_F(Program, KeepsAnEarlierChartUnlessForced) {
  std::ofstream(folder / "chart.csv") << "earlier\n";
  expect_refused("chart --quick --problem bar --output \"$F\"", "--force");
  EXPECT_EQ(content(folder / "chart.csv"), "earlier\n");
  expect_refused("chart --quick --problem bar --output \"$F/chart.csv\"", "chart.csv");
  expect_refused("tune --problem bar --error 1% --output \"$F\"", "chart.csv");
}

}  // namespace
