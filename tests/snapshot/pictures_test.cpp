// SPDX-License-Identifier: MIT
#include <blasting/pictures.hpp>
#include <program/gnuplot.hpp>
#include <mpm/io/csv.hpp>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include "run_python.hpp"
#include "temporary_folder.hpp"

namespace {

using namespace blasting;
using program::Gnuplot;

/// The pixel of a field picture, from its lower left corner, that shows (x, y) of a window from -1 to 1 m.
std::array<int, 2> pixel(double x, double y) {
  return {120 + static_cast<int>((x + 1) * 500), 95 + static_cast<int>((y + 1) * 500)};
}

struct Colours {
  int status = 0, width = 0, height = 0;
  std::vector<std::array<int, 3>> pixels{};
};

Colours read_picture(const TemporaryFolder& folder, const std::vector<std::array<int, 2>>& where) {
  std::ofstream list(folder / "pixels.txt");
  for (const auto& [x, y] : where) list << x << ' ' << y << '\n';
  list.close();
  Colours colours{.status = run_python("read_picture.py", folder.path())};
  std::istringstream in(content(folder / "colours.txt"));
  in >> colours.width >> colours.height;
  for (std::array<int, 3> c; in >> c[0] >> c[1] >> c[2];) colours.pixels.push_back(c);
  return colours;
}

TEST(Pictures, RasterShowsEachDomainWhereItIs) {
  const Picture picture{.half_width = 1};
  const Quad skewed{{{-0.5, -0.5}, {0.5, -0.5}, {0.75, 0.25}, {-0.25, 0.25}}};
  const auto seen = rasterise(picture, std::vector{skewed, square({-0.9, 0.9}, 0.1)}, std::vector{3.0, 4.0});
  const auto at = [&](double x, double y) {
    return seen[static_cast<std::size_t>((y + 1) * 500) * picture_pixels + static_cast<std::size_t>((x + 1) * 500)];
  };
  EXPECT_EQ(at(0, 0), 3);
  EXPECT_EQ(at(0.7, 0.24), 3);
  EXPECT_TRUE(std::isnan(at(-0.3, 0.24)));  // left of the slanted side
  EXPECT_TRUE(std::isnan(at(0.7, -0.24)));
  EXPECT_EQ(at(-0.9, 0.9), 4);
  EXPECT_TRUE(std::isnan(at(0.9, 0.9)));
  EXPECT_TRUE(std::isnan(at(-0.9, -0.9)));
  const auto filled = [&](float value) { return std::count(seen.begin(), seen.end(), value); };
  EXPECT_NEAR(static_cast<double>(filled(3)), 0.75 * 250000, 400);  // area over that of a pixel
  EXPECT_EQ(filled(4), 2500);
}

// Neighbours that share an edge leave no hairline between them and do not overlap, whichever way they go around.
TEST(Pictures, NeighboursTileTheWindow) {
  std::vector<Quad> domains;
  const auto corner = [](int i, int j) {
    const double x = -1.2 + 0.1 * i, y = -1.2 + 0.1 * j;
    return Vec2{x + 0.03 * std::sin(7 * y), y + 0.03 * std::cos(5 * x)};
  };
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 24; ++j)
      if ((i + j) % 2)
        domains.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
      else
        domains.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)});
  std::vector<double> values(domains.size());
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = static_cast<double>(p);
  auto seen = rasterise({.half_width = 1}, domains, values);
  EXPECT_TRUE(std::ranges::none_of(seen, [](float value) { return std::isnan(value); }));
  std::ranges::reverse(domains);
  std::ranges::reverse(values);
  EXPECT_EQ(rasterise({.half_width = 1}, domains, values), seen);  // the order matters only where domains overlap
}

// Corners and edges that run exactly through the centres of pixels belong to one side.
TEST(Pictures, CornersOnPixelCentresLeaveNoGap) {
  std::vector<Quad> domains;
  const auto corner = [](int i, int j) { return Vec2{-600.5 + 50 * i + 10 * (j % 2), -600.5 + 50 * j + 10 * (i % 3)}; };
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 24; ++j)
      domains.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  const auto seen = rasterise({.half_width = 500}, domains, std::vector<double>(domains.size(), 1));
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1.F), 1000000);
}

TEST(Pictures, QuarterIsMirroredToAllQuadrants) {
  const Picture picture{.centre = {5, -3}, .half_width = 1, .quarter = true};
  const auto seen = rasterise(picture, std::vector{square({5.5, -2.75}, 0.2)}, std::vector{1.0});
  for (const int x : {250, 749})
    for (const int y : {375, 624}) EXPECT_EQ(seen[y * picture_pixels + x], 1) << x << ' ' << y;
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1.F), 4 * 10000);
}

TEST(Pictures, DamageSaysWhichKindIsLarger) {
  EXPECT_EQ(signed_damage(0.25, 0.75), 0.75);
  EXPECT_EQ(signed_damage(0.75, 0.25), -0.75);
  EXPECT_EQ(signed_damage(0, 0), 0);
}

TEST(Pictures, FieldPictureHasTheColoursOfItsValues) {
  const TemporaryFolder folder;
  const std::vector domains{square({-0.5, 0.5}, 0.4), square({0.5, 0.5}, 0.4), square({0.5, -0.5}, 0.4)};
  const Picture picture{.title = "it's \"90\" `date` $HOME \\ µs\n",
                        .field = damage_field,
                        .holes = {{}, {.9, -.9}},
                        .hole_radius = 0.05};
  if (!draw_field(picture, domains, std::vector{-1.0, 1.0, 0.0}, folder / "picture.png"))
    FAIL() << "gnuplot is not there";
  EXPECT_EQ(count_files(folder.path(), ""), 1);  // the work folder is gone
  const auto found =
      read_picture(folder, {pixel(-0.5, 0.5), pixel(0.5, 0.5), pixel(0.5, -0.5), pixel(-0.5, -0.5), pixel(0, 0.05)});
  if (found.status == 77) FAIL() << "VTK for Python (python3-vtk9) is not there";
  EXPECT_EQ(found.width, 1360);
  EXPECT_EQ(found.height, 1170);
  ASSERT_EQ(found.pixels.size(), 5U);
  const auto near = [](const std::array<int, 3>& a, const std::array<int, 3>& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 30;
  };
  EXPECT_TRUE(near(found.pixels[0], {0x7d, 0x0a, 0x12})) << "crushed is dark red";
  EXPECT_TRUE(near(found.pixels[1], {0x0c, 0x10, 0x18})) << "cracked is black";
  EXPECT_TRUE(near(found.pixels[2], {0xf6, 0xf0, 0xe2})) << "intact is light";
  EXPECT_TRUE(near(found.pixels[3], {0xd9, 0xdd, 0xe2})) << "no particle is grey";
  EXPECT_GT(found.pixels[4][1], found.pixels[4][0]) << "the hole's outline is green-blue";
}

TEST(Pictures, DivergingColoursAreSymmetricAndOutliersDoNotFadeThem) {
  const TemporaryFolder folder;
  const std::vector domains{square({-0.5, 0}, 0.9), square({0.5, 0}, 0.9), square({0, 0.9}, 0.02),
                            square({0, 0.6}, 0.2)};
  if (!draw_field({.field = hoop_stress_field}, domains, std::vector{-40e6, 40e6, 9e9, 0.0}, folder / "picture.png"))
    FAIL() << "gnuplot is not there";
  const auto found = read_picture(folder, {pixel(-0.5, 0), pixel(0.5, 0), pixel(0, 0.9), pixel(0, 0.6)});
  if (found.status == 77) FAIL() << "VTK for Python (python3-vtk9) is not there";
  ASSERT_EQ(found.pixels.size(), 4U);
  EXPECT_GT(found.pixels[0][2], found.pixels[0][0] + 60) << "compression is blue";
  EXPECT_GT(found.pixels[1][0], found.pixels[1][2] + 60) << "tension is red";
  EXPECT_EQ(found.pixels[2], found.pixels[1]) << "an outlier takes the last colour";
  EXPECT_GT(found.pixels[3][0] + found.pixels[3][1] + found.pixels[3][2], 720) << "zero is white";
}

TEST(Pictures, ChartDrawsTheColumnsOfATable) {
  const TemporaryFolder folder;
  mpm::io::CsvWriter table(folder / "energies.csv", {{"time", "s"}, {"kinetic", "J/m"}, {"it's", "J/m"}});
  const Chart chart{.title = "Energies", .quantity = "energy", .unit = "kJ/m", .scale = 1e-3};
  EXPECT_THROW(draw_chart(chart, folder / "energies.csv", folder / "picture.png"), std::runtime_error);
  for (int i = 0; i < 20; ++i) table.row(std::vector{i * 1e-5, 1e3 * i, std::nan("")});
  table.row(std::vector{20e-5, 0.0, 1.0});
  auto absent = chart;
  absent.columns = {"potential"};
  EXPECT_THROW(draw_chart(absent, folder / "energies.csv", folder / "picture.png"), std::invalid_argument);
  if (!draw_chart(chart, folder / "energies.csv", folder / "picture.png")) FAIL() << "gnuplot is not there";
  const auto found = read_picture(folder, {{1, 1}});
  if (found.status == 77) FAIL() << "VTK for Python (python3-vtk9) is not there";
  EXPECT_EQ(found.width, 1200);
  EXPECT_EQ(found.height, 720);
}

TEST(Pictures, FailureCarriesGnuplotsWords) {
  const TemporaryFolder folder;
  try {
    if (!Gnuplot(folder / "picture.png").draw(100, 100, "plot no_such_variable\n")) FAIL() << "gnuplot is not there";
    FAIL() << "a script that cannot run went through";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no_such_variable"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THROW(Gnuplot(folder / "nowhere/picture.png"), std::runtime_error);
  EXPECT_THROW(draw_field({}, std::vector<Quad>(2), std::vector{1.0}, folder / "picture.png"), std::invalid_argument);
}

TEST(Pictures, WithoutGnuplotThereIsAWarningAndNoPicture) {
  const TemporaryFolder folder;
  const char* variable = std::getenv("PATH");
  const std::string path = variable ? variable : "";
  setenv("PATH", folder.path().c_str(), 1);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 2; ++i)
    EXPECT_FALSE(
        draw_field({.field = pressure_field}, std::vector{square({0, 0}, 1)}, std::vector{1.0}, folder / "p.png"));
  const std::string warning = testing::internal::GetCapturedStderr();
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(warning, "warning: gnuplot is not on the PATH: no pictures are drawn\n");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
