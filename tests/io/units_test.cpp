// SPDX-License-Identifier: MIT
#include <mpm/io/units.hpp>
#include <gtest/gtest.h>
#include <bit>
#include <cstdint>
#include <random>
#include <string>

namespace {

using mpm::io::format_quantity;
using mpm::io::InputError;
using mpm::io::parse_integer;
using mpm::io::parse_quantity;

std::string error_of(const std::string& text, const std::string& unit) {
  try {
    parse_quantity(text, unit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// The comparisons are exact: a unit must not cost a bit.
TEST(Units, ScaleToSiWithoutRounding) {
  EXPECT_EQ(parse_quantity("1.32 g/cm^3", "kg/m^3"), 1320.0);
  EXPECT_EQ(parse_quantity("2.66 g/cm^3", "kg/m^3"), 2660.0);
  EXPECT_EQ(parse_quantity("21 mm", "m"), 0.021);
  EXPECT_EQ(parse_quantity("5mm", "m"), 0.005);
  EXPECT_EQ(parse_quantity("300 us", "s"), 300e-6);
  EXPECT_EQ(parse_quantity("25 ns", "s"), 25e-9);
  EXPECT_EQ(parse_quantity("1.5e-3 km", "m"), 1.5);
  EXPECT_EQ(parse_quantity("-4500 GPa", "Pa"), -4.5e12);
  EXPECT_EQ(parse_quantity("51188.28 MPa", "Pa"), 51188.28e6);
  EXPECT_EQ(parse_quantity("573100000 kPa", "Pa"), 573.1e9);
  EXPECT_EQ(parse_quantity("7190001 kJ/m^3", "kJ/m^3"), 7190001e3);
  EXPECT_EQ(parse_quantity("500 J/m^2", "J/m^2"), 500.0);
  EXPECT_EQ(parse_quantity("500 N/m", "J/m^2"), 500.0);
  EXPECT_EQ(parse_quantity("6.69 mm/us", "m/s"), 6690.0);
  EXPECT_EQ(parse_quantity("0.1", "m"), 0.1);
  EXPECT_EQ(parse_quantity("0 mm", "m"), 0.0);
}

TEST(Units, ErrorsSayWhatIsWrong) {
  EXPECT_EQ(error_of("abc", "m"), "not a number");
  EXPECT_EQ(error_of("", "m"), "not a number");
  EXPECT_EQ(error_of("nan", "m"), "not a finite number");
  EXPECT_EQ(error_of("inf mm", "m"), "not a finite number");
  EXPECT_EQ(error_of("1e999", "m"), "too large or too small for a double");
  EXPECT_EQ(error_of("1e308 km", "m"), "too large or too small for a double");
  EXPECT_EQ(error_of("5 kg", "mm"), "the unit \"kg\" has the wrong dimension, expected one like mm");
  EXPECT_EQ(error_of("5 g/cm^2", "kg/m^3"), "the unit \"g/cm^2\" has the wrong dimension, expected one like kg/m^3");
  EXPECT_EQ(error_of("5 mm", ""), "expected a plain number, found the unit \"mm\"");
  EXPECT_EQ(error_of("5 Mpa", "MPa"), "unknown unit \"Mpa\", the nearest known one is MPa");
  EXPECT_EQ(error_of("5 m^x", "m"), "the exponent of \"m^x\" is not a small integer");
  EXPECT_EQ(error_of("5 J/", "J"), "a unit ends in * or /");
  EXPECT_EQ(error_of("5,3 mm", "mm").substr(0, 12), "unknown unit");
}

TEST(Units, FormatIsWhatAPersonWouldWrite) {
  EXPECT_EQ(format_quantity(0.021, "mm"), "21 mm");
  EXPECT_EQ(format_quantity(300e-6, "us"), "300 us");
  EXPECT_EQ(format_quantity(-4.5e12, "GPa"), "-4500 GPa");
  EXPECT_EQ(format_quantity(51188.28e6, "MPa"), "51188.28 MPa");
  EXPECT_EQ(format_quantity(1.225, "kg/m^3"), "1.225 kg/m^3");
  EXPECT_EQ(format_quantity(0.0005, "mm"), "0.5 mm");
  EXPECT_EQ(format_quantity(1e-6, ""), "1e-6");
  EXPECT_EQ(format_quantity(1.25e-7, ""), "1.25e-7");
  EXPECT_EQ(format_quantity(0, "mm"), "0 mm");
}

TEST(Units, EveryDoubleReadsBackToTheSameBits) {
  std::mt19937_64 random(7);
  int tried = 0;
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (!(std::abs(value) > 1e-290 && std::abs(value) < 1e290)) continue;
    ++tried;
    for (const char* unit : {"", "mm", "GPa", "g/cm^3", "us"})
      ASSERT_EQ(parse_quantity(format_quantity(value, unit), unit), value) << format_quantity(value, unit);
  }
  EXPECT_GT(tried, 15000);
}

TEST(Units, IntegersAreWhole) {
  EXPECT_EQ(parse_integer(" 20 "), 20);
  EXPECT_EQ(parse_integer("-3"), -3);
  for (const char* bad : {"4.0", "1e3", "6 mm", "", "x", "99999999999"})
    EXPECT_THROW(parse_integer(bad), InputError) << bad;
}

TEST(Units, EditDistanceAndNearest) {
  EXPECT_EQ(mpm::io::edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(mpm::io::edit_distance("", "abc"), 3u);
  EXPECT_EQ(mpm::io::edit_distance("abc", "abc"), 0u);
  EXPECT_EQ(mpm::io::nearest("horizntal", {"vertical", "horizontal", "start"}), "horizontal");
}

TEST(Units, AMessageIsAlwaysOneLine) {
  EXPECT_STREQ(InputError("a\nb\r\tc").what(), "a?b??c");
  EXPECT_EQ(mpm::io::shown(std::string(100, 'x')).size(), 65u);
}

}  // namespace
