// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/materials/neo_hookean.hpp>
#include <cmath>

namespace mpm::problems {

/// Strain energy of a body of NeoHookean, J: the integral of W = lambda/2 (ln J)^2 + mu/2 (tr b - 3) - mu ln J over its
/// reference volume, the potential of the law's stress.
template <class Body>
double strain_energy(const Body& body) {
  const NeoHookean& law = body.law;
  const double lambda = lame_modulus(law.young, law.poisson), mu = shear_modulus(law.young, law.poisson);
  double sum = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const auto F = body.F(p);
    const double log_J = std::log(double(determinant(F))), trace_b = double(trace(symmetric(F * transpose(F))));
    sum += double(body.mass()[p]) / law.density * (lambda / 2 * log_J * log_J + mu / 2 * (trace_b - 3) - mu * log_J);
  }
  return sum;
}

}  // namespace mpm::problems
