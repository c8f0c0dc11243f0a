// SPDX-License-Identifier: MIT
// expect: Material
// expect: law\.update\(state, step\)
#include <mpm/mpm.hpp>

struct Law : mpm::Hypoelastic {
#ifdef MPM_FAULT
  void update() const {}
#endif
};

int main() {
  mpm::Solver<mpm::PerBody<mpm::Linear, mpm::Ugimp>, mpm::PerBody<mpm::Hypoelastic, Law>, mpm::Usl>* solver = nullptr;
  if (solver) solver->step();
}
