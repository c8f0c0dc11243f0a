// SPDX-License-Identifier: MIT
// expect: mpm::Body: CPDI domains tangle in the flow of a gas; give the gas mpm::Ugimp or mpm::QuadraticBspline
#include <mpm/mpm.hpp>

#ifdef MPM_FAULT
using Shape = mpm::CpdiQuad;
#else
using Shape = mpm::Ugimp;
#endif

int main() {
  mpm::Solver<Shape, mpm::JonesWilkinsLee, mpm::Musl> solver{mpm::Grid<mpm::PlaneStrain<>>{{0, 0}, 1, {4, 4}},
                                                             mpm::Body<Shape, mpm::JonesWilkinsLee>{}};
  solver.step();
}
