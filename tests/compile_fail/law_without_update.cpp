// SPDX-License-Identifier: MIT
#include <mpm/concepts/material.hpp>
#include <array>

// expect: static assertion failed|static_assert failed
// expect: law\.update

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
  State<V> update(const State<V>& state, const mpm::Increment<V>&) const {
    return state;
  }
#endif
  template <class V>
  mpm::Moduli<V> tangent(const State<V>&, const V&) const {
    return {V(1e9), V(4e8)};
  }
};
static_assert(mpm::Material<Law>);
