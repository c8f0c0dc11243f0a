// SPDX-License-Identifier: MIT
// expect: mpm::ShapeFunction: domain_motion is `corners`, so the shape must
// expect: convect\(body, velocity, dt, corners, particles\), which moves its domains
#include <mpm/mpm.hpp>

struct Shape : mpm::CpdiQuad {
#ifdef MPM_FAULT
  void convect() {}
#endif
};

void run(mpm::Solver<Shape, mpm::Hypoelastic, mpm::Usl>& solver) {
  solver.step();
}
