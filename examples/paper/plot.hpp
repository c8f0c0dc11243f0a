// SPDX-License-Identifier: MIT
#pragma once
#include <blasting/pictures.hpp>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

// Figures of several panels, drawn by gnuplot as blasting/pictures.hpp says.
namespace paper {

struct Curve {
  std::string name{};  ///< empty: not in the legend
  std::vector<double> x{}, y{};
  std::string style = "lines linewidth 2";  ///< gnuplot's words
};

/// One panel of curves.
struct Axes {
  std::string title{}, x{}, y{};  ///< labels with units
  std::vector<Curve> curves{};
  std::string extra{};  ///< further gnuplot lines, such as ranges
};

/// Draws the panels, row by row, and writes the curves into a CSV of the same name: panel, curve, x, y.
void draw_curves(const std::vector<Axes>& panels, int columns, const std::filesystem::path& png);

/// One square picture of a field about the origin.
struct Tile {
  std::string title{};
  std::vector<float> values{};                          ///< as blasting::rasterise gives them
  std::vector<blasting::Vec2> holes{blasting::Vec2{}};  ///< centres of the circles drawn, m
};

/// What the tiles of one figure share.
struct TileStyle {
  std::string quantity{};  ///< label of the colour bar, with unit
  blasting::ColourMap colours = blasting::ColourMap::damage;
  double low = -1, high = 1;      ///< ends of the colour bar
  double half_width = 1;          ///< of the window, m
  double hole = 0;                ///< radius of the circles, m
  int columns = 4, pixels = 250;  ///< of a tile's side: a divisor of blasting::picture_pixels
};

/// Draws the tiles at one scale, row by row, with one colour bar.
void draw_tiles(const std::vector<Tile>& tiles, const TileStyle& style, const std::filesystem::path& png);

}  // namespace paper
