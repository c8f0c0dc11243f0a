// SPDX-License-Identifier: MIT
// expect: mpm::ShapeFunction: `reach\(body, p, grid\)` is missing, by which particles are ordered for the threads
#include <mpm/mpm.hpp>

struct Shape : mpm::Linear {
#ifdef MPM_FAULT
  void reach() const {}
#endif
};

void run(mpm::Solver<Shape, mpm::Hypoelastic, mpm::Usl>& solver) {
  solver.step();
}
