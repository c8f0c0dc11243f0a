// SPDX-License-Identifier: MIT
// expect: mpm::PerBody: the columns of Shape and Material differ in length
// expect: give one entry a body in each, or one policy for all
#include <mpm/mpm.hpp>

#ifdef MPM_FAULT
using Shapes = mpm::PerBody<mpm::CpdiQuad, mpm::Ugimp, mpm::Ugimp>;
#else
using Shapes = mpm::PerBody<mpm::CpdiQuad, mpm::Ugimp>;
#endif
using Laws = mpm::PerBody<mpm::Hypoelastic, mpm::PolynomialEos>;

void run(mpm::Solver<Shapes, Laws, mpm::Usl>& solver) {
  solver.step();
}
