// SPDX-License-Identifier: MIT
// expect: ShapeFunction
// expect: domain_motion
#include <mpm/mpm.hpp>

struct Shape {
#ifndef MPM_FAULT
  static constexpr mpm::DomainMotion domain_motion = mpm::DomainMotion::rigid;
#endif
  template <class S>
  static constexpr int max_nodes = 1;
  template <class S>
  static constexpr std::size_t bytes = 0;
  void permute(std::span<const std::uint32_t>) {}
};

int main() {
  mpm::Body<Shape, mpm::Hypoelastic> body;
  return int(body.size());
}
