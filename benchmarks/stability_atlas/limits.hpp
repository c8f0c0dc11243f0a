// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mpm::atlas {

/// Growth a step of blocks of one method, by offset from a node and step.
struct GrowthMap {
  std::string space, shape, integrator;
  int per_edge = 0;
  std::vector<double> offsets{};  ///< cells
  std::vector<double> steps{};    ///< h/c
  std::vector<double> growth{};   ///< a step, offset by offset
  std::vector<double> certain{};  ///< the solver's own step at safety 1, h/c, of each offset
};

/// Steps of blocks of one method, the least of several offsets, h/c.
struct Limit {
  std::string space, shape, integrator;
  int per_edge = 0;
  double certain = 0;  ///< the solver's own at safety 1
  double limit = 0;    ///< beyond which motions grow
  double nodal = 0;    ///< 2/w of the nodes with lumped masses
  double share = 0;    ///< certain over limit, mean of the offsets
};

/// From one particle an edge to twenty on lines and in the plane, to four in space.
std::vector<GrowthMap> growth_maps(bool quick);
std::vector<Limit> limits(bool quick);

void write(const std::vector<GrowthMap>& maps, const std::filesystem::path& file);
void write(const std::vector<Limit>& limits, const std::filesystem::path& file);

/// A picture growth_SPACE_SHAPE.png each, a panel an integrator and number of particles, with the certain step on them.
void draw_each(const std::vector<GrowthMap>& maps, const std::filesystem::path& folder);
/// The limits on a line by particles an edge, a panel an integrator. False if gnuplot is missing.
bool draw(const std::vector<Limit>& limits, const std::filesystem::path& png);

/// The limits at two particles an edge as a Markdown table.
std::string markdown(const std::vector<Limit>& limits);

}  // namespace mpm::atlas
