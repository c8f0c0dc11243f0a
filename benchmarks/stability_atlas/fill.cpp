// SPDX-License-Identifier: MIT
#include "fill.hpp"
#include <cmath>

namespace mpm::atlas {

Fill random_fill(int dimension, int most, Random& random) {
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  const auto among = [&](int low, int high) { return std::uniform_int_distribution<>(low, high)(random); };
  Fill f;
  f.per_edge = among(1, among(0, 1) ? 4 : 20);
  const int longest = int(std::pow(most, 1. / dimension) + 1e-9);
  for (std::size_t d = 0; d < 3; ++d) {
    f.count[d] = among(1, longest);
    f.offset[d] = uniform(0, 1);
    f.margin[d] = 2 * among(0, 1);
  }
  if (among(0, 1)) {
    for (double& s : f.stretch) s = std::exp(uniform(std::log(.4), std::log(2.5)));
    f.shear = uniform(-.5, .5);
  }
  if (among(0, 1)) f.jitter = .2;
  if (among(0, 1)) f.kept = uniform(.2, 1);
  f.poisson = uniform(0, .45);
  return f;
}

}  // namespace mpm::atlas
