// SPDX-License-Identifier: MIT
#pragma once

namespace mpm::analysis {

/// State of a gas in one-dimensional (plane, cylindrical or spherical) flow.
struct GasState {
  double density{};   ///< kg/m3
  double velocity{};  ///< along the axis or radius, m/s
  double pressure{};  ///< Pa

  /// Internal energy per mass of an ideal gas of heat capacity ratio `gamma`, J/kg.
  double energy(double gamma) const { return pressure / ((gamma - 1) * density); }
};

}  // namespace mpm::analysis
