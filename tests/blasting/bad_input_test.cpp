// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

// Every kind of bad input, fed to the real program: exit code 2, one line that names the culprit, no output touched.
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Case {
  const char* name;
  std::string file;               ///< the scene file's text; empty: no file
  std::vector<std::string> args;  ///< further arguments
  std::vector<std::string> says;  ///< what the line must hold
};

class BadInput : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    for (char& c : test) c = c == '/' ? '_' : c;
    folder = fs::path(::testing::TempDir()) / ("bad_input_" + test);
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override {
    fs::permissions(folder, fs::perms::owner_all);
    fs::remove_all(folder);
  }

  /// The exit code. The time limit only matters where bad input is taken for good and the blast begins.
  int run(const std::vector<std::string>& args) const {
    std::string command = "timeout 20 '" MPM_BLASTING_PROGRAM "'";
    for (const auto& arg : args) command += " '" + arg + "'";
    command += " >'" + (folder / "stdout").string() + "' 2>'" + (folder / "stderr").string() + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  void expect_refused(const std::vector<std::string>& args, const std::vector<std::string>& says) const {
    EXPECT_EQ(run(args), 2);
    EXPECT_EQ(contents(folder / "stdout"), "");
    const std::string line = contents(folder / "stderr");
    EXPECT_EQ(line.find('\n'), line.size() - 1) << "not exactly one line: " << line;
    EXPECT_TRUE(line.starts_with("error: ")) << line;
    for (const auto& word : says) EXPECT_NE(line.find(word), std::string::npos) << "no " << word << " in: " << line;
  }

  fs::path folder;
};

TEST_P(BadInput, IsRefusedBeforeAnyWork) {
  const Case& bad = GetParam();
  std::vector<std::string> args{"--output", (folder / "out").string()};
  if (!bad.file.empty()) {
    std::ofstream(folder / "scene.info") << bad.file;
    args.insert(args.end(), {"--scene", (folder / "scene.info").string()});
  }
  args.insert(args.end(), bad.args.begin(), bad.args.end());
  expect_refused(args, bad.says);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

std::vector<Case> cases() {
  return {
      {"SnapBack",
       "rock { tensile { fracture_energy 100 J/m^2 } }\n",
       {},
       {"rock.tensile.fracture_energy", "snap back"}},
      {"MissingFile", "", {"--scene", "/nowhere/scene.info"}, {"/nowhere/scene.info", "cannot read"}},
      {"FolderAsFile", "", {"--scene", "/"}, {"cannot read"}},
      {"SyntaxError", "hole {\n  radius 21 mm\n", {}, {"scene.info:", "unmatched {"}},
      {"UnknownKey", "hole {\n  raduis 21 mm\n}\n", {}, {"scene.info:2", "hole.raduis", "hole.radius"}},
      {"UnknownKeySet", "", {"--set", "stress.horizntal=20 MPa"}, {"--set", "stress.horizntal", "stress.horizontal"}},
      {"SectionAsKey", "hole 21 mm\n", {}, {"scene.info:1", "hole", "section"}},
      {"WrongTypeNumber", "end_time soon\n", {}, {"scene.info:1", "end_time", "soon", "number"}},
      {"WrongTypeInteger", "gas { particles_per_edge 2.5 }\n", {}, {"gas.particles_per_edge", "2.5", "integer"}},
      {"WrongTypeSwitch", "air { fill maybe }\n", {}, {"air.fill", "maybe", "true or false"}},
      {"WrongChoice", "charge { kind tnt }\n", {}, {"charge.kind", "tnt", "petn"}},
      {"NoValue", "seed\n", {}, {"scene.info:1", "seed", "no value"}},
      {"BadUnit", "hole { radius 21 mn }\n", {}, {"hole.radius", "21 mn", "unit"}},
      {"WrongDimension", "stress { vertical 20 mm }\n", {}, {"stress.vertical", "20 mm", "MPa"}},
      {"OutOfRange", "\nstep { safety 1.2 }\n", {}, {"scene.info:2", "step.safety", "1.2", "range"}},
      {"NegativeCount", "", {"--set", "output.snapshots=-1"}, {"output.snapshots", "-1", "range"}},
      {"HugeCount", "", {"--set", "relaxation.max_steps=4294967297"}, {"relaxation.max_steps", "4294967297"}},
      {"FlipOutOfRange", "", {"--set", "step.flip=1.01"}, {"step.flip", "1.01", "range"}},
      {"NotANumber", "", {"--set", "hole.radius=nan"}, {"hole.radius", "nan", "finite"}},
      {"Infinite", "", {"--set", "charge.A=inf"}, {"charge.A", "inf", "finite"}},
      {"DuplicateKey", "seed 1\nend_time 1 us\nseed 1\n", {}, {"scene.info:3", "seed", "twice"}},
      {"DuplicateSet", "", {"--set", "seed=1", "--set", "seed=2"}, {"--set", "seed", "twice"}},
      {"SetWithoutValue", "", {"--set", "seed"}, {"--set", "seed", "key=value"}},
      {"ChargeWiderThanHole", "charge { radius 22 mm }\n", {}, {"charge.radius", "22 mm", "hole.radius"}},
      {"ChargeSticksOut", "model full\ncharge { x 6 mm }\n", {}, {"charge.x", "6 mm", "hole"}},
      {"HoleOffTheBlock", "model full\nhole { x 3 m }\n", {}, {"hole.x", "block"}},
      {"HoleTooCloseToTheSide", "model full\nhole { y 1.15 m }\n", {}, {"hole.y", "block"}},
      {"UnsymmetricQuarter", "hole { x 5 mm }\n", {}, {"hole.x", "model", "full"}},
      {"TurnedQuarter",
       "stress { vertical 40 MPa\n direction 30 }\n",
       {},
       {"stress.direction = 30", "multiple of 90", "full"}},
      {"SquaresOfElasticRock", "rock { shape ugimp\n law elastic }\n", {}, {"rock.shape", "rock.law"}},
      {"ElasticRockInFloat", "step { precision float }\nrock { law elastic }\n", {}, {"step.precision", "rock.law"}},
      {"SquaresInFloat", "step { precision float }\nrock { shape ugimp }\n", {}, {"step.precision", "rock.shape"}},
      {"ParticleWiderThanCell", "rock { particle 2 cm }\n", {}, {"rock.particle", "grid.cell"}},
      {"ProbeInTheHole", "output { probes 1 mm }\n", {}, {"output.probes"}},
      {"TooFewProbeDirections", "output { probe_directions 90 }\n", {}, {"output.probe_directions", "2 output.probes"}},
      {"ProbeOutsideTheQuarter", "output { probe_directions 0, 180 }\n", {}, {"output.probes", "quarter"}},
      {"HolesOverlap", "model full\nhole { x 0, 3 cm\n y 0, 0 }\n", {}, {"hole.x", "30 mm", "overlap", "126 mm"}},
      {"HoleWithoutY", "model full\nhole { x 0, 1 }\n", {}, {"hole.y", "hole.x has 2"}},
      {"DelayForNoHole", "charge { delay 0, 25 us }\n", {}, {"charge.delay", "25 us", "one delay a hole"}},
      {"UnknownOption", "", {"--treads", "2"}, {"--treads"}},
      {"NoThreads", "", {"--threads", "0"}, {"--threads"}},
      {"StrayWord", "", {"paper.info"}, {"paper.info", "--scene"}},
      {"LineBreakInAKey", "", {"--set", "a\nb=1"}, {"unknown key"}},
  };
}

INSTANTIATE_TEST_SUITE_P(Every, BadInput, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return std::string(test.param.name); });

using Output = BadInput;

TEST_F(Output, HoldingAnEarlierResultIsLeftAlone) {
  const fs::path result = folder / "result";
  fs::create_directory(result);
  std::ofstream(result / "summary.json") << "an earlier result";
  expect_refused({"--output", result.string()}, {"--output", result.string(), "--force"});
  EXPECT_EQ(contents(result / "summary.json"), "an earlier result");
  // --force does not excuse a bad scene: the earlier result stays.
  expect_refused({"--output", result.string(), "--force", "--set", "seed=-1"}, {"seed"});
  EXPECT_EQ(contents(result / "summary.json"), "an earlier result");
  EXPECT_EQ(std::distance(fs::directory_iterator(result), {}), 1);
}

TEST_F(Output, BelowAFileIsRefused) {
  std::ofstream(folder / "file") << "text";
  expect_refused({"--output", (folder / "file").string()}, {"--output", "not a folder"});
  expect_refused({"--output", (folder / "file" / "out").string()}, {"--output", "cannot be written"});
  EXPECT_EQ(contents(folder / "file"), "text");
}

// /proc takes no files, not even root's.
TEST_F(Output, WithoutPermissionIsRefused) {
  expect_refused({"--output", "/proc/out"}, {"--output", "cannot be written"});
}

// The runner itself can see success: without this, a program that always fails would pass.
TEST_F(Output, HelpSucceeds) {
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_EQ(contents(folder / "stderr"), "");
  EXPECT_NE(contents(folder / "stdout").find("stress.horizontal"), std::string::npos);
}

}  // namespace
