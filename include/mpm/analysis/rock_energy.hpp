// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/materials/hypoelastic.hpp>
#include <mpm/materials/johnson_holmquist2.hpp>
#include <mpm/materials/rankine_softening.hpp>
#include <algorithm>
#include <cmath>

// Where the work done on rock is: stored as strain, or spent in opening cracks. What is left of it went into crushing
// and viscosity.
namespace mpm::analysis {

namespace detail {

/// JH-2's energy per initial volume, J/m3: the integral of P dmu/(1 + mu)^2 up to the compression mu, with the pressure
/// of bulking acting all the way and the tension no larger than the cap, and that of the deviator.
inline double stored(const JohnsonHolmquist2& rock, const SymmetricTensor<double>& deviator, double mu, double bulking,
                     double damage, double J) {
  mu = std::max(mu, -rock.tensile_pressure * (1 - damage) / rock.K1);
  const double u = 1 + mu, ln = std::log(u);
  double volumetric = rock.K1 * (ln + 1 / u - 1);
  if (mu > 0) {
    volumetric += rock.K2 * (u - 2 * ln - 1 / u) + rock.K3 * (u * u / 2 - 3 * u + 3 * ln + 1 / u + 1.5);
    volumetric += bulking * mu / u;
  }
  return volumetric + J * inner(deviator, deviator) / (4 * rock.shear());
}

}  // namespace detail

/// Elastic energy per initial volume of rock in this state at the relative volume J, J/m3.
inline double elastic_energy(const JohnsonHolmquist2& rock, const JohnsonHolmquist2::State<double>& s, double J) {
  return detail::stored(rock, deviator(s.stress), 1 / J - 1, s.bulking, s.damage, J);
}
inline double elastic_energy(const Hypoelastic& rock, const Hypoelastic::State<double>& s, double J) {
  const auto d = deviator(s.stress);
  const double p = trace(s.stress) / 3, G = shear_modulus(rock.young, rock.poisson);
  const double K = rock.young / (3 * (1 - 2 * rock.poisson));
  return J * (inner(d, d) / (4 * G) + p * p / (2 * K));
}
/// Cracked rock stores the share of its uncracked part and that of the rock between open cracks.
template <class Rock>
double elastic_energy(const WithTensileLaw<Rock>& rock, const typename WithTensileLaw<Rock>::template State<double>& s,
                      double J) {
  const double d = s.cracking, mu = 1 / J - 1;
  if (d < 1e-3) return detail::stored(rock, deviator(s.stress), mu, s.bulking, s.damage, J);
  const auto between = (1 / d) * (deviator(s.stress) - (1 - d) * s.trial);
  return (1 - d) * detail::stored(rock, s.trial, mu, s.bulking, s.damage, J) +
         d * detail::stored(rock, between, mu + s.opening, s.bulking, s.damage, J);
}

/// Energy that opening cracks has taken per present volume of a particle of this size (m), J/m3: fracture_energy/size
/// once it is fully cracked, before that what linear softening has dissipated; nothing in rock without a tensile law.
template <class Rock>
double fracture_energy_spent(const Rock& rock, const typename Rock::template State<double>& s, double size) {
  if constexpr (requires { rock.tension; }) {
    const double longitudinal = rock.K1 + 4.0 / 3 * rock.shear(), kept = 1 - s.cracking;
    const double end =
        std::max(2 * longitudinal * rock.tension.fracture_energy / (s.strength * size), 1.0001 * s.strength);
    const double stress = kept * end / (kept * (end - s.strength) + s.strength);  // over the strength
    return rock.tension.fracture_energy / size * (1 - stress);
  } else {
    return 0;
  }
}

}  // namespace mpm::analysis
