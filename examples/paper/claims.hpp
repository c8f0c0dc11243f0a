// SPDX-License-Identifier: MIT
#pragma once
#include "case.hpp"
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

// What Xiao et al. 2024 say of their twelve blasts (section 4.2 and Fig. 11), and whether it is so here.
namespace paper {

/// In-situ stress, MPa: horizontal, vertical.
using State = std::pair<double, double>;
inline constexpr std::array<double, 6> equiaxial_levels{0, 10, 20, 30, 40, 50};  ///< MPa
inline constexpr std::array<double, 6> lateral_ratios{.25, .5, 1, 1.5, 2, 3};    ///< k
inline constexpr double vertical_stress = 40;                                    ///< MPa, beside k

/// What the claims need of one blast; lengths in m, areas in m2, stresses in Pa, tension positive.
struct Measured {
  double reach{}, along_x{}, along_y{}, area{};
  double crushed{};      ///< radius of the circle that hole and crushed rock would fill
  double late_growth{};  ///< of the reach in the last fifth of the time, relative
  double longest{};      ///< direction of the longest crack, degrees from x, 0 to 90
  double compression{};  ///< largest radial one at `probe_radius`
  double tension{};      ///< largest hoop one there
  double hole{}, half_side{};
};
/// Of the stresses that are compared, m: beyond the cracks, whose rock carries less the more it is cracked.
inline constexpr double probe_radius = 0.8;
using States = std::map<State, Measured>;

/// Throws std::runtime_error where the run's tables cannot be read.
Measured measure(const Blast& blast);

/// A statement and what was found.
struct Finding {
  std::string claim{}, measured{};
  bool holds = false;
  std::vector<bool> by_seed{};  ///< the same on coarse cells, for the seeds 1, 2, ... of the rock's scatter
};

/// Every claim on the twelve states, which must all be there.
std::vector<Finding> judge(const States& states);

/// `%.*f`, for texts.
std::string fixed(double value, int digits);

}  // namespace paper
