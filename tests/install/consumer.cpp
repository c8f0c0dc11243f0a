// SPDX-License-Identifier: MIT
#include <mpm/concepts/material.hpp>
#include <cstdio>

int main() {
  const mpm::SymmetricTensor<double> uniaxial{.xx = -3.0, .yy = 0, .zz = 0, .xy = 0, .yz = 0, .zx = 0};
  std::printf("equivalent stress %.3f\n", mpm::equivalent_stress(uniaxial));
}
