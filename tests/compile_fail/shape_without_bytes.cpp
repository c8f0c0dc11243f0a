// SPDX-License-Identifier: MIT
// expect: mpm::ShapeFunction: `bytes<Space>` is missing, what the shape stores a particle beside the body's fields
#include <mpm/mpm.hpp>

struct Shape : mpm::Linear {
#ifdef MPM_FAULT
  void bytes() const {}
#endif
};

int main() {
  mpm::Body<Shape, mpm::Hypoelastic> body;
  return int(body.size());
}
