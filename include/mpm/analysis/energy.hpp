// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body.hpp>

namespace mpm {

/// Kinetic energy of a body's particles, J (a metre of depth in plane strain, a radian in a space with a hoop
/// direction).
template <class Body>
double kinetic_energy(const Body& body) {
  double sum = 0;
  for (std::size_t p = 0; p < body.size(); ++p)
    sum += 0.5 * double(body.mass()[p]) * double(body.velocity(p).squaredNorm());
  return sum;
}

/// Momentum of a body's particles, kg m/s.
template <class Body>
Vector<typename Body::SpaceType> momentum(const Body& body) {
  Vector<typename Body::SpaceType> sum = Vector<typename Body::SpaceType>::Zero();
  for (std::size_t p = 0; p < body.size(); ++p) sum += body.mass()[p] * body.velocity(p);
  return sum;
}

}  // namespace mpm
