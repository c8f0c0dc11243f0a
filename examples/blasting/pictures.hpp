// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

// Pictures of a run, drawn by gnuplot (terminal pngcairo), looked up on the PATH. Without gnuplot a warning is printed
// once and no picture appears: a run does not fail for a picture.
namespace blasting {

using Vec2 = std::array<double, 2>;
using Quad = std::array<Vec2, 4>;  ///< the corners of a particle's domain, around, m

/// The domain of a particle that stays an upright square.
inline Quad square(const Vec2& centre, double width) {
  const double h = width / 2;
  return {{{centre[0] - h, centre[1] - h},
           {centre[0] + h, centre[1] - h},
           {centre[0] + h, centre[1] + h},
           {centre[0] - h, centre[1] + h}}};
}

/// How values become colours, and which values the colour bar spans. Values beyond it take the colour of its end.
enum class ColourMap {
  sequential,  ///< dark to light, from the 1st to the 99th percentile of what is seen
  diverging,   ///< blue, white at 0, red; symmetric, to the 98th percentile of the magnitudes seen
  damage       ///< signed_damage(): crushed in reds, intact light, cracked in blacks; from -1 to 1
};

/// The gnuplot lines that set the colours of a map.
std::string palette(ColourMap colours);

/// The gnuplot lines that draw circles, as objects 2, 3, ...
std::string circles(const std::vector<Vec2>& centres, double radius);

/// A quantity as it is drawn.
struct Field {
  std::string name{};
  std::string unit{};  ///< of the colour bar
  double scale = 1;    ///< what turns SI into that unit
  ColourMap colours = ColourMap::sequential;
};
inline const Field damage_field{"damage", "1", 1, ColourMap::damage};
inline const Field hoop_stress_field{"hoop stress, tension positive", "MPa", 1e-6, ColourMap::diverging};
inline const Field pressure_field{"pressure", "MPa", 1e-6, ColourMap::sequential};

/// One of two damages of one particle, with a sign that says which: crushed (shear under pressure) in [-1, 0] where it
/// is more than half crushed or less cracked, else cracked (tension) in [0, 1]. Crushed rock is cracked as well.
inline double signed_damage(double crushed, double cracked) {
  return crushed > 0.5 || crushed > cracked ? -crushed : cracked;
}

/// A square window on the particles around the holes.
struct Picture {
  std::string title{};
  Field field{};
  Vec2 centre{};              ///< of the window, m
  std::vector<Vec2> holes{};  ///< centres, m; their first outlines are drawn as circles
  double hole_radius = 0;     ///< m
  double half_width = 1;      ///< of the window, m
  bool quarter = false;       ///< the particles fill x, y above the centre only; the picture mirrors them
};

/// Side of a field picture's window, pixels.
inline constexpr int picture_pixels = 1000;

/// What is seen: the values, in SI, at the centres of picture_pixels^2 pixels, rows from below; NaN where no particle
/// is. A later particle covers an earlier one.
std::vector<float> rasterise(const Picture& picture, std::span<const Quad> domains, std::span<const double> values);

/// Draws one value a particle into a PNG file. False if gnuplot is missing. Throws std::invalid_argument if there are
/// not as many values as domains, std::runtime_error with gnuplot's words if the picture cannot be made.
bool draw_field(const Picture& picture, std::span<const Quad> domains, std::span<const double> values,
                const std::filesystem::path& png);

/// Curves over time from a table whose header reads `time [s],name [unit],...`.
struct Chart {
  std::string title{};
  std::string quantity{};              ///< label of the upright axis, without unit
  std::string unit{};                  ///< of the upright axis
  double scale = 1;                    ///< what turns the table's unit into that one
  std::vector<std::string> columns{};  ///< names of the columns to draw; empty: all
};

/// Draws columns of a table over its first one, the time, into a PNG file. False if gnuplot is missing. Throws
/// std::invalid_argument for a column that is not there, std::runtime_error if the table cannot be read, has no row, or
/// the picture cannot be made.
bool draw_chart(const Chart& chart, const std::filesystem::path& csv, const std::filesystem::path& png);

}  // namespace blasting
