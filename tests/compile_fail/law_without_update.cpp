// SPDX-License-Identifier: MIT
// expect: Material
// expect: law\.update\(state, step\)
#include <mpm/mpm.hpp>

struct Law {
  template <class V>
  struct State {
    mpm::SymmetricTensor<V> stress{};
  };
  static constexpr std::array<const char*, 0> history{};
  double density = 1000;

  template <class V>
  State<V> initial() const {
    return {};
  }
#ifndef MPM_FAULT
  template <class V>
  void update(State<V>&, const mpm::Increment<V>&) const {}
#endif
  template <class V>
  mpm::Moduli<V> tangent(const State<V>&, const V&) const {
    return {V(1e9), V(4e8)};
  }
};

int main() {
  mpm::Body<mpm::Linear, Law> body;
  return int(body.size());
}
