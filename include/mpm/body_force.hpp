// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body.hpp>
#include <concepts>
#include <cstddef>

namespace mpm {

/// BODY FORCE: what acts on the mass of a particle, m/s2. A value that the solver carries, called as
///   - `body_force(body, p, time)`: b of particle p at `time`, the start of the step, s; a Vector of the body's space.
/// It is called once a particle and step, by several threads at once. Particles are reordered as they move, so what
/// tells one from another (a reference position, say) belongs into the history of its law, not into an array beside it.
template <class B, class Body>
concept BodyForce = std::default_initializable<B> && requires(const B b, const Body body, double time) {
  { b(body, std::size_t{}, time) } -> std::convertible_to<Vector<typename Body::SpaceType>>;
};

/// One vector for every particle and time, assigned like a vector: `solver.body_force = {0, -9.81}`.
template <Space S>
class UniformBodyForce {
 public:
  UniformBodyForce() = default;
  explicit UniformBodyForce(const Vector<S>& b) : b_(b) {}
  UniformBodyForce& operator=(const Vector<S>& b) {
    b_ = b;
    return *this;
  }
  typename S::Scalar& operator[](int axis) { return b_[axis]; }

  template <class Body>
  const Vector<S>& operator()(const Body&, std::size_t, double) const {
    return b_;
  }

 private:
  Vector<S> b_ = Vector<S>::Zero();
};

}  // namespace mpm
