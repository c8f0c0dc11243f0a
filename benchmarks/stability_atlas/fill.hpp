// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <random>

namespace mpm::atlas {

using Random = std::mt19937_64;

/// A lattice of particles in a grid of unit cells, distorted, with holes; components beyond the space's are not used.
struct Fill {
  double per_edge = 2;             ///< particles a cell edge, before the lattice is distorted
  std::array<int, 3> count{};      ///< particles along each axis
  std::array<double, 3> offset{};  ///< of the lowest particle edge from a node, 0 to 1
  std::array<int, 3> margin{};     ///< cells below that node, to the face of the grid
  std::array<double, 3> stretch{1, 1, 1};
  double shear = 0;    ///< of x by y, in a plane
  double jitter = 0;   ///< of every particle, or corner, at most, in spacings
  double kept = 1;     ///< share of the particles that is not left out
  double poisson = 0;  ///< Young's modulus and density are 1
};

/// A fill of at most `most` particles at random: 1 to 20 an edge, anywhere in a cell and at faces or not, stretched to
/// between .4 and 2.5, sheared, with holes and jitter, or not.
Fill random_fill(int dimension, int most, Random& random);

}  // namespace mpm::atlas
