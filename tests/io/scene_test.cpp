// SPDX-License-Identifier: MIT
#include "command_line.hpp"
#include <gtest/gtest.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

using blasting::Options;
using blasting::Scene;
using mpm::io::InputError;

template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

Scene with(const std::vector<std::string>& set) {
  Options options;
  options.set = set;
  return blasting::read_scene(options);
}

std::string invalid(const std::vector<std::string>& set) {
  return error_of([&] { blasting::validate(with(set)); });
}

Options parsed(std::vector<const char*> words) {
  words.insert(words.begin(), "blasting");
  return blasting::parse(static_cast<int>(words.size()), words.data());
}

/// The text that reproduces a scene; two scenes are the same where these are.
std::string text(Scene scene) {
  std::string all;
  for (const auto& parameter : blasting::parameters(scene))
    all += parameter.name + " = " + mpm::io::value_text(parameter) + "\n";
  return all;
}

TEST(Scene, DefaultIsThePaperAndValid) {
  const Scene scene;
  EXPECT_EQ(invalid({}), "no error");
  EXPECT_EQ(scene.hole.radius, 0.021);
  EXPECT_EQ(scene.charge.radius, 0.016);
  EXPECT_EQ(scene.grid.cell, 0.01);
  EXPECT_EQ(scene.rock.particle, 0.005);
  EXPECT_EQ(scene.stress.horizontal, 20e6);
  EXPECT_EQ(scene.stress.vertical, 20e6);
  EXPECT_EQ(scene.air.density, 1.225);
}

TEST(Scene, SetReachesEveryKindOfMember) {
  const Scene scene =
      with({"hole.x = -5 mm, 1 m", "charge.delay=0, 25 us", "charge.kind=none", "charge.density=1.32 g/cm^3",
            "rock.K2=-4500 GPa", "rock.tensile.law=none", "seed=42", "output.probes=10 cm, 0.3", "air.fill=false",
            "step.update=usf", "model=full", "rock.preset=granite_3000"});
  EXPECT_EQ(scene.hole.x, (std::vector<double>{-0.005, 1}));
  EXPECT_EQ(scene.charge.delay, (std::vector<double>{0, 25e-6}));
  EXPECT_EQ(scene.charge.kind, blasting::ChargeKind::none);
  EXPECT_EQ(scene.charge.density, 1320.0);
  EXPECT_EQ(scene.rock.K2, -4.5e12);
  EXPECT_EQ(scene.rock.tensile.law, blasting::TensileLaw::none);
  EXPECT_EQ(scene.seed, 42);
  EXPECT_EQ(scene.output.probes, (std::vector<double>{0.1, 0.3}));
  EXPECT_FALSE(scene.air.fill);
  EXPECT_EQ(scene.step.update, blasting::StressUpdate::usf);
  EXPECT_EQ(scene.model, blasting::Model::full);
  EXPECT_EQ(scene.rock.preset, blasting::RockPreset::granite_3000);
  EXPECT_FALSE(scene.rock.K1.has_value());
}

// No two keys may share a variable, and none may be bound to another's: give each key alone a new value and see that
// the text of this key and of no other changes.
TEST(Scene, EachKeyChangesItselfAndNothingElse) {
  Scene fresh;
  const auto before = blasting::parameters(fresh);
  for (std::size_t i = 0; i < before.size(); ++i) {
    std::string value = "0.25";
    if (const auto* choice = std::get_if<mpm::io::Choice>(&before[i].slot)) {
      const auto& words = choice->words;
      value = words.back() == mpm::io::value_text(before[i]) ? words.front() : words.back();
    }
    if (std::holds_alternative<bool*>(before[i].slot)) value = "false";
    if (std::holds_alternative<int*>(before[i].slot)) value = "17";
    if (before[i].range.min >= 100) value = mpm::io::format_quantity(2 * before[i].range.min, "");
    Scene changed = with({before[i].name + "=" + value});
    const auto after = blasting::parameters(changed);
    for (std::size_t j = 0; j < after.size(); ++j)
      EXPECT_EQ(mpm::io::value_text(after[j]) != mpm::io::value_text(before[j]), i == j)
          << before[i].name << "=" << value << " and " << after[j].name;
  }
}

TEST(Scene, AWrittenSceneReproducesTheRun) {
  const Scene scene = with({"stress.horizontal=13.7 MPa", "charge.A=573.1 GPa", "rock.D1=0.005", "output.probes=none",
                            "rock.law=elastic", "end_time=123.456789 us"});
  Options options;
  options.scene = ::testing::TempDir() + "a_written_scene.info";
  blasting::write_scene(scene, options.scene);
  EXPECT_EQ(text(blasting::read_scene(options)), text(scene));
  EXPECT_NE(text(scene), text(Scene{}));
  std::filesystem::remove(options.scene);
}

TEST(Scene, PaperSceneHoldsThePaper) {
  Options options;
  options.scene = MPM_BLASTING_SCENES "/paper.info";
  const Scene scene = blasting::read_scene(options);
  blasting::validate(scene);
  EXPECT_EQ(scene.grid.cell / scene.gas.particles_per_edge, 0.0005);
  EXPECT_EQ(scene.charge.preset, blasting::ChargePreset::petn_as_printed);
  EXPECT_EQ(scene.rock.preset, blasting::RockPreset::paper);
  EXPECT_EQ(scene.air.density, 0.001225);
  EXPECT_EQ(scene.stress.horizontal, 20e6);
  EXPECT_EQ(scene.stress.vertical, 20e6);
}

TEST(Scene, TheCommandLineOverridesTheFile) {
  Options options;
  options.scene = MPM_BLASTING_SCENES "/paper.info";
  options.set = {"stress.vertical=40 MPa"};
  const Scene scene = blasting::read_scene(options);
  EXPECT_EQ(scene.stress.vertical, 40e6);
  EXPECT_EQ(scene.stress.horizontal, 20e6);
}

TEST(Validate, TheChargeFitsTheHole) {
  EXPECT_EQ(invalid({"charge.radius=22 mm"}),
            "charge.radius = 22 mm: the charge is wider than the hole, keep it at most hole.radius = 21 mm");
  EXPECT_EQ(invalid({"charge.radius=21 mm"}), "no error");
  EXPECT_EQ(invalid({"charge.radius=22 mm", "charge.kind=none"}), "no error");
  EXPECT_EQ(invalid({"model=full", "charge.x=-3 mm", "charge.y=4.1 mm"}).substr(0, 16), "charge.x = -3 mm");
  EXPECT_EQ(invalid({"model=full", "charge.y=5.1 mm"}),
            "charge.y = 5.1 mm: the charge sticks out of the hole, keep its offset plus charge.radius at most "
            "hole.radius = 21 mm");
  EXPECT_EQ(invalid({"model=full", "charge.x=-3 mm", "charge.y=4 mm"}), "no error");
}

TEST(Validate, ABurnSpeedNeedsAProgrammedBurn) {
  EXPECT_EQ(invalid({"charge.detonation_velocity=6690 m/s"}),
            "charge.detonation_velocity = 6690 m/s: a constant-volume burn has none, set charge.burn to programmed");
  EXPECT_EQ(invalid({"charge.detonation_velocity=6690 m/s", "charge.burn=programmed"}), "no error");
}

TEST(Validate, TheHoleFitsTheBlock) {
  EXPECT_EQ(invalid({"model=full", "hole.y=-3 m"}),
            "hole.y = -3000 mm: the hole leaves the block; its centre must stay 63 mm (3 radii) inside a block.side of "
            "2.4 m");
  EXPECT_NE(invalid({"model=full", "hole.x=1.15 m"}).find("too close"), std::string::npos);
  EXPECT_EQ(invalid({"model=full", "hole.x=1.13 m", "output.probes=none"}), "no error");
  EXPECT_EQ(invalid({"block.side=4 cm"}).substr(0, 46), "block.side = 0.04 m: the hole leaves the block");
}

TEST(Validate, HolesAreApartAndEachIsWhole) {
  EXPECT_EQ(invalid({"model=full", "hole.x=0, 30 mm", "hole.y=0, 30 mm"}),
            "hole.x = 0 mm, 30 mm: holes 1 and 2 are too close to each other; set them at least 126 mm (6 radii) apart "
            "along x or y");
  EXPECT_NE(invalid({"model=full", "hole.x=0, 30 mm", "hole.y=0, 0"}).find("holes 1 and 2 overlap"), std::string::npos);
  EXPECT_EQ(invalid({"model=full", "hole.x=0, 10 mm", "hole.y=0, 126 mm", "charge.delay=0, 1 ms"}), "no error");
  EXPECT_EQ(invalid({"model=full", "hole.x=0, 0.2"}),
            "hole.y = 0 mm: each hole needs both coordinates, and hole.x has 2");
  EXPECT_EQ(invalid({"hole.x=none", "hole.y=none"}), "hole.x = none: a blast needs a hole");
  EXPECT_EQ(invalid({"model=full", "hole.x=0, 1.15", "hole.y=0, 0"}).substr(0, 34),
            "hole.x = 1150 mm: the hole is too ");
  EXPECT_EQ(invalid({"charge.delay=0, 1 us"}),
            "charge.delay = 0 us, 1 us: give one delay a hole, and there are 1 in hole.x, or none");
  EXPECT_EQ(invalid({"hole.x=0, 0.2", "hole.y=0, 0"}),
            "hole.x = 0 mm, 200 mm: a quarter model has one hole, set model to full");
}

TEST(Validate, AQuarterModelNeedsASymmetricScene) {
  for (const char* key : {"hole.x", "hole.y", "charge.x", "charge.y"}) {
    EXPECT_EQ(invalid({std::string(key) + "=1 mm"}),
              std::string(key) + " = 1 mm: a quarter model needs a symmetric scene, set model to full");
    EXPECT_EQ(invalid({std::string(key) + "=1 mm", "model=full"}), "no error");
  }
}

TEST(Validate, AQuarterModelNeedsStressesAlongItsSides) {
  EXPECT_EQ(
      invalid({"stress.vertical=40 MPa", "stress.direction=30"}),
      "stress.direction = 30: a quarter model needs its principal stresses along x and y, take a multiple of 90 or "
      "set model to full");
  for (const char* instead : {"stress.direction=-90", "model=full", "stress.horizontal=40 MPa"})
    EXPECT_EQ(invalid({"stress.vertical=40 MPa", instead,
                       std::string(instead).starts_with("stress.d") ? "seed=1" : "stress.direction=30"}),
              "no error");
}

TEST(Validate, TheResolutionMakesSense) {
  EXPECT_EQ(invalid({"grid.cell=22 mm"}).substr(0, 17), "grid.cell = 22 mm");
  EXPECT_EQ(invalid({"rock.particle=11 mm"}).substr(0, 21), "rock.particle = 11 mm");
  EXPECT_EQ(invalid({"rock.particle=1 um"}).substr(0, 24), "rock.particle = 0.001 mm");
  EXPECT_EQ(invalid({"output.probes=20 mm"}),
            "output.probes = 0.02 m: not in the rock, keep it beyond 21 mm and within the quarter");
  EXPECT_EQ(invalid({"output.probes=0.1, 2 m"}).substr(0, 19), "output.probes = 2 m");
}

TEST(Validate, RangesHoldForASceneMadeInCode) {
  Scene scene;
  scene.step.flip = 1.5;
  EXPECT_EQ(error_of([&] { blasting::validate(scene); }), "step.flip = \"1.5\": out of range, valid: 0 to 1");
  scene = {};
  scene.end_time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of([&] { blasting::validate(scene); }), "end_time = \"nan\": not a finite number");
}

TEST(CommandLine, ReadsEveryOption) {
  const Options o = parsed({"--scene", "a.info", "--set", "seed=2", "--set", "hole.x=-1 mm", "--threads", "3",
                            "--output=there", "--dry-run", "--force"});
  EXPECT_EQ(o.scene, "a.info");
  EXPECT_EQ(o.set, (std::vector<std::string>{"seed=2", "hole.x=-1 mm"}));
  EXPECT_EQ(o.threads, 3);
  EXPECT_EQ(o.output, "there");
  EXPECT_TRUE(o.dry_run && o.force && !o.help);
  const Options none = parsed({});
  EXPECT_TRUE(none.scene.empty() && none.set.empty() && none.threads == 0 && !none.dry_run && !none.force);
}

TEST(CommandLine, RefusesWhatItDoesNotKnow) {
  EXPECT_NE(error_of([] { parsed({"--colour"}); }).find("--colour"), std::string::npos);
  EXPECT_NE(error_of([] { parsed({"--out", "x"}); }).find("--out"), std::string::npos);
  EXPECT_EQ(error_of([] { parsed({"paper.info"}); }),
            "stray word \"paper.info\": a scene file is given as --scene FILE");
  for (const char* n : {"0", "-3", "two", "1.5", "99999"})
    EXPECT_NE(error_of([&] { parsed({"--threads", n}); }).find("--threads"), std::string::npos) << n;
  EXPECT_NE(error_of([] { parsed({"--set"}); }).find("--set"), std::string::npos);
  EXPECT_EQ(error_of([] { with({"seed"}); }), "--set \"seed\": expected key=value");
  EXPECT_EQ(error_of([] { with({"seed=1", "seed=2"}); }), "--set: seed = \"2\": this key is given twice, keep one");
}

TEST(CommandLine, HelpListsEveryKeyWithItsDefaultAndMeaning) {
  std::ostringstream out;
  blasting::print_help(out);
  std::istringstream lines(out.str());
  Scene scene;
  const auto all = blasting::parameters(scene);
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line);)
    for (const auto& p : all)
      if (line.starts_with("  " + p.name + " ")) {
        ++found;
        EXPECT_NE(line.find(p.text), std::string::npos) << line;
        EXPECT_NE(line.find(mpm::io::value_text(p)), std::string::npos) << line;
        EXPECT_NE(line.find(p.unit), std::string::npos) << line;
      }
  EXPECT_EQ(found, all.size());
}

TEST(Output, IsFreshOrForced) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(::testing::TempDir()) / "output_is_fresh";
  fs::remove_all(folder);
  blasting::prepare_output(folder / "a" / "b", false);
  EXPECT_TRUE(fs::is_empty(folder / "a" / "b"));
  blasting::prepare_output(folder / "a" / "b", false);  // an empty folder is fresh

  std::ofstream(folder / "summary.json") << "old";
  const std::string error = error_of([&] { blasting::prepare_output(folder, false); });
  EXPECT_NE(error.find("--force"), std::string::npos) << error;
  EXPECT_TRUE(fs::exists(folder / "summary.json"));
  const std::string not_a_folder = error_of([&] { blasting::prepare_output(folder / "summary.json", true); });
  EXPECT_NE(not_a_folder.find("not a folder"), std::string::npos) << not_a_folder;
  EXPECT_NE(error_of([&] { blasting::prepare_output(folder / "summary.json" / "x", true); }), "no error");
  EXPECT_TRUE(fs::exists(folder / "summary.json"));

  blasting::prepare_output(folder, true);
  EXPECT_FALSE(fs::exists(folder / "summary.json"));
  EXPECT_TRUE(fs::exists(folder / "a" / "b"));
  fs::remove_all(folder);
}

}  // namespace
