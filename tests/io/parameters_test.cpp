// SPDX-License-Identifier: MIT
#include <mpm/io/info_file.hpp>
#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

using mpm::io::InputError;
using mpm::io::Parameters;

enum class Colour { red, green };

struct Things {
  double width = 0.5;
  std::optional<double> extra;
  std::vector<double> list{1, 2};
  int count = 3;
  bool on = false;
  Colour colour = Colour::red;

  Parameters parameters() {
    return {{"box.width", &width, "mm", "a width", {0, 2, true}},
            {"box.inner.extra", &extra, "MPa", "an override"},
            {"box.list", &list, "m", "a list", {0, 10}},
            {"count", &count, "", "a count", {0, 9}},
            {"on", &on, "", "a switch"},
            {"colour", mpm::io::Choice(colour, {"red", "green"}), "", "a choice"}};
  }
};

class InfoFile : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path); }

  void read(const std::string& text) {
    std::ofstream(path) << text;
    mpm::io::assign_all(things.parameters(), mpm::io::read_info(path));
  }

  /// The error's line, with the folder of the file cut off.
  std::string error_of(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      const std::string line = error.what(), folder = path.parent_path().string() + "/";
      return line.starts_with(folder) ? line.substr(folder.size()) : line;
    }
    return "no error";
  }

  const std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) /
      (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".info");
  Things things;
};

TEST_F(InfoFile, ReadsEveryKindOfValue) {
  read(
      "; a comment { with braces\n"
      "box { width 21 mm   ; 21 kg\n"
      "  inner\n  {\n    extra \"40 MPa\"\n  }\n"
      "  list 10 cm, 0.2,3 m }\n"
      "count 7\r\n"
      "on true\n"
      "colour green");
  EXPECT_EQ(things.width, 0.021);
  EXPECT_EQ(things.extra, 40e6);
  EXPECT_EQ(things.list, (std::vector<double>{0.1, 0.2, 3}));
  EXPECT_EQ(things.count, 7);
  EXPECT_TRUE(things.on);
  EXPECT_EQ(things.colour, Colour::green);
}

TEST_F(InfoFile, LeavesWhatIsNotGivenAtItsDefault) {
  read("box { }\nbox.list none\n");  // a section may be empty, a key may be written with dots
  EXPECT_EQ(things.width, 0.5);
  EXPECT_FALSE(things.extra.has_value());
  EXPECT_TRUE(things.list.empty());
  EXPECT_EQ(things.count, 3);
}

TEST_F(InfoFile, ErrorsNameTheLineTheKeyAndTheRemedy) {
  const std::string at = "ErrorsNameTheLineTheKeyAndTheRemedy.info:";
  EXPECT_EQ(error_of("count 1\n\nbox {\n  widht 5 mm\n}"),
            at + "4: unknown key \"box.widht\", the nearest known key is box.width");
  EXPECT_EQ(error_of("box 3"), at + "1: \"box\" is a section and has no value of its own, only keys between braces");
  EXPECT_EQ(error_of("\nbox { width 5 kg }"),
            at + "2: box.width = \"5 kg\": the unit \"kg\" has the wrong dimension, expected one like mm");
  EXPECT_EQ(error_of("box { width 0 }"), at + "1: box.width = \"0\": out of range, valid: above 0 mm to 2000 mm");
  EXPECT_EQ(error_of("box {\nlist 1, 11 m }"), at + "2: box.list = \"1, 11 m\": out of range, valid: 0 m to 10 m");
  EXPECT_EQ(error_of("count -1"), at + "1: count = \"-1\": out of range, valid: 0 to 9");
  EXPECT_EQ(error_of("count 2.5"), at + "1: count = \"2.5\": not an integer");
  EXPECT_EQ(error_of("count"), at + "1: count = \"\": has no value");
  EXPECT_EQ(error_of("on yes"), at + "1: on = \"yes\": expected true or false");
  EXPECT_EQ(error_of("colour gren"), at + "1: colour = \"gren\": expected one of red, green; the nearest is green");
  EXPECT_EQ(error_of("box { width nan }"), at + "1: box.width = \"nan\": not a finite number");
}

TEST_F(InfoFile, RefusesAKeyGivenTwice) {
  const std::string at = "RefusesAKeyGivenTwice.info:";
  EXPECT_EQ(error_of("count 1\ncount 1\n"), at + "2: count = \"1\": this key is given twice, keep one");
  EXPECT_EQ(error_of("box { width 1 }\nbox {\n  width 2\n}\n"),
            at + "3: box.width = \"2\": this key is given twice, keep one");
}

TEST_F(InfoFile, SyntaxErrorsNameTheLine) {
  const std::string at = "SyntaxErrorsNameTheLine.info:";
  EXPECT_EQ(error_of("count 1\n}\n"), at + "2: unmatched }; check the braces and quotes up to here");
  EXPECT_EQ(error_of("count \"1\n"), at + "1: unexpected end of line; check the braces and quotes up to here");
  EXPECT_EQ(error_of("box {\n").substr(at.size() + 1), ": unmatched {; check the braces and quotes up to here");
  EXPECT_EQ(error_of("\n#include \"x\"\n"), at + "2: a line cannot start with #; comments start with ;");
}

TEST_F(InfoFile, RefusesAMissingFileAndAFolder) {
  EXPECT_THROW(mpm::io::read_info(path.string() + ".nowhere"), InputError);
  EXPECT_THROW(mpm::io::read_info(path.parent_path()), InputError);
}

TEST_F(InfoFile, WrittenParametersReadBackToTheSameBits) {
  things.width = 0.1 + 0.2;
  things.extra = 51188.28e6 / 3;
  things.list = {1.0 / 3, 1e-7};
  things.colour = Colour::green;
  const Things written = things;
  std::ostringstream out;
  mpm::io::write_info(out, things.parameters());
  things = {};
  read(out.str());
  EXPECT_EQ(things.width, written.width);
  EXPECT_EQ(things.extra, written.extra);
  EXPECT_EQ(things.list, written.list);
  EXPECT_EQ(things.colour, written.colour);
}

TEST_F(InfoFile, WritesNestedSectionsAndLeavesOutWhatWasNotGiven) {
  std::ostringstream out;
  mpm::io::write_info(out, things.parameters());
  EXPECT_EQ(out.str(),
            "box {\n  width \"500 mm\"  ; a width\n  list \"1 m, 2 m\"  ; a list\n}\n"
            "count \"3\"  ; a count\non \"false\"  ; a switch\ncolour \"red\"  ; a choice\n");
}

}  // namespace
