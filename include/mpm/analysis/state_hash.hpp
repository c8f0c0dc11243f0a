// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/columns.hpp>
#include <cstddef>
#include <cstdint>

namespace mpm {

/// 64-bit FNV-1a hash (Fowler, Noll & Vo) of bytes, added one range after the other.
class StateHash {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) value_ = (value_ ^ byte[i]) * 0x100000001b3u;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// Adds the whole state of a body, bit for bit: every column in the order of its particles, and the corners and
/// quadrilaterals of a shape that has them.
template <class Body>
void add_state(StateHash& hash, const Body& body) {
  for (int k = 0; k < Body::column_count; ++k) hash.add(body.columns()[k], body.size() * sizeof(typename Body::Scalar));
  if constexpr (requires { body.shape.corner, body.shape.quad; }) {
    hash.add(body.shape.corner.data(), body.shape.corner.size() * sizeof(body.shape.corner[0]));
    hash.add(body.shape.quad.data(), body.shape.quad.size() * sizeof(body.shape.quad[0]));
  }
}

/// Hash of the whole state of a solver: its time, its bodies and what its integrator keeps for their particles. Equal
/// for equal bits only, so two runs of one binary that differ in nothing but their number of threads must agree.
template <class Solver>
std::uint64_t state_hash(Solver& solver) {
  StateHash hash;
  hash.add(&solver.time, sizeof solver.time);
  solver.for_bodies([&](const auto& body) { add_state(hash, body); });
  solver.for_particle_columns([&]<class T, int Count>(const Columns<T, Count>& columns) {
    for (int k = 0; k < Count; ++k) hash.add(columns[k], columns.size() * sizeof(T));
  });
  return hash.value();
}

}  // namespace mpm
