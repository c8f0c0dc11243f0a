// SPDX-License-Identifier: MIT
// expect: mpm::Integrator: `advance\(grid, dt\)` is missing, which Solver::step calls to move the nodes
#include <mpm/mpm.hpp>

struct Mine : mpm::Usl {
#ifdef MPM_FAULT
  void advance() const {}
#endif
};

void run(mpm::Solver<mpm::Linear, mpm::Hypoelastic, Mine>& solver) {
  solver.step();
}
