// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

// A blast that cannot go on: what the real program says, and what it leaves on disk.
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs a small blast with `settings` on top, which must fail, say `words`, and leave its last good state.
void expect_failure(const std::string& name, const std::string& settings, const std::vector<std::string>& words) {
  const fs::path out = fs::path(::testing::TempDir()) / name;
  fs::remove_all(out);
  const std::string command = "'" MPM_BLASTING_PROGRAM "' --output '" + out.string() +
                              "' --set 'block.side=0.3 m' --set 'output.probes=0.1 m' --set 'end_time=100 us' --set "
                              "output.snapshots=0 --set rock.law=elastic " +
                              settings + " >'" + out.string() + ".txt' 2>&1";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 1);
  const std::string said = contents(out.string() + ".txt");
  for (const std::string& part : words)
    EXPECT_NE(said.find(part), std::string::npos) << "no " << part << " in: " << said;
  for (const char* file : {"last_good.hdf.series", "last_good_000000.hdf", "scene.info"})
    EXPECT_TRUE(fs::exists(out / file)) << file;
  EXPECT_NE(contents(out / "summary.json").find("false"), std::string::npos);
}

// Soft rock round forty times the energy of PETN: a quadrilateral of the wall turns inside out.
TEST(BlastGuard, NamesTheParticleAndLeavesTheLastGoodState) {
  expect_failure(
      "blast_guard", "--set 'rock.young=300 MPa' --set 'charge.E0=100000000 kJ/m^3'",
      {"error: particle ", " of rock at (", "has a domain turned inside out, in step ", "refine the grid there",
       "; the last good state, step ", "last_good.hdf.series, and scene.info beside it repeats the run"});
}

// So few steps of relaxation that no rock comes to rest in them.
TEST(BlastGuard, ARelaxationThatFindsNoRestLeavesItsState) {
  expect_failure("relaxation_guard", "--set relaxation.max_steps=120 --set stress.start=far_field",
                 {"error: relax: not at rest after 120 steps", "raise max_steps", "; the last good state, step ",
                  "scene.info beside it repeats the run"});
}

}  // namespace
