// SPDX-License-Identifier: MIT
#include <mpm/analysis/bessel_k.hpp>
#include <mpm/analysis/durbin.hpp>
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace {
using namespace mpm::analysis;
using Complex = std::complex<double>;

// exp(z) K0(z) and exp(z) K1(z), computed with 40 digits.
struct Reference {
  Complex z, k0, k1;
};
const Reference reference[] = {
    {{0.1, 0}, {2.6823261022628944, 0}, {10.890182683049697, 0}},
    {{2, 0}, {0.84156821507077142, 0}, {1.0334768470686886, 0}},
    {{10, 0}, {0.39163193443659867, 0}, {0.41076657059578875, 0}},
    {{0.01, 0.02}, {3.9770437752801305, -1.0383674103580344}, {20.972253642996501, -40.029611647442289}},
    {{1, 1}, {0.93500640104750335, -0.34129054457006628}, {1.0876250904549452, -0.61899076169637371}},
    {{0.05, 2.5}, {0.58585579668962593, -0.52296273753592655}, {0.49671394874547622, -0.64710587091257182}},
    {{3.9, 0.2}, {0.61610927811634517, -0.0149659116932745}, {0.6907153689135157, -0.020436659566212826}},
    {{0.1, 3.99}, {0.46017404201791904, -0.42238171557916722}, {0.41284954656345277, -0.48341766033888887}},
    {{0.1, 4.01}, {0.45895807095582128, -0.42143834066654238}, {0.41194451544821968, -0.48200051228323238}},
    {{3, 3}, {0.55477296964257567, -0.21823676503216067}, {0.58369764908449366, -0.27922935620359314}},
    {{0.2, 15}, {0.23212298957140614, -0.22527440679810906}, {0.22485751371643101, -0.23322262088000306}},
    {{20, 30}, {0.18394913866732432, -0.09777543477303168}, {0.1842509113295839, -0.10063719294474164}},
    {{0.5, 400}, {0.044352816581114446, -0.044269733165199988}, {0.044297583625026202, -0.044325277682306208}},
    {{800, 1}, {0.044304401543247019, -2.7681597750152226e-5}, {0.044332083086965343, -2.7733484489060214e-5}}};

TEST(BesselK, ReferenceValuesInTheRightHalfPlane) {
  for (const auto& [z, k0, k1] : reference) {
    const ScaledBesselK k = scaled_bessel_k(z);
    EXPECT_LT(std::abs(k.k0 - k0), 1e-12 * std::abs(k0)) << z;
    EXPECT_LT(std::abs(k.k1 - k1), 1e-12 * std::abs(k1)) << z;
    const ScaledBesselK mirrored = scaled_bessel_k(std::conj(z));
    EXPECT_LT(std::abs(mirrored.k1 - std::conj(k1)), 1e-12 * std::abs(k1)) << z;
  }
}

TEST(BesselK, SeriesAndQuadratureMeetOnTheirSeam) {
  for (double angle = -1.57; angle < 1.58; angle += 0.157) {
    const Complex z = std::polar(4.0, angle);
    const ScaledBesselK series = detail::bessel_k_series(z), quadrature = detail::bessel_k_quadrature(z);
    EXPECT_LT(std::abs(series.k0 / quadrature.k0 - 1.0), 3e-13) << z;
    EXPECT_LT(std::abs(series.k1 / quadrature.k1 - 1.0), 3e-13) << z;
  }
}

TEST(BesselK, DerivativeOfK0IsMinusK1) {
  for (const Complex z : {Complex(0.7, 0.2), Complex(1, 5), Complex(0.05, 12)}) {
    const double h = 1e-4;  // d/dz [e^z K0] = e^z K0 - e^z K1
    const Complex slope = (scaled_bessel_k(z + h).k0 - scaled_bessel_k(z - h).k0) / (2 * h);
    const ScaledBesselK k = scaled_bessel_k(z);
    EXPECT_LT(std::abs(slope - (k.k0 - k.k1)), 1e-7) << z;
  }
}

TEST(Durbin, KnownPairs) {
  const double omega = 40;
  const auto pairs = [&](Complex m) {
    return std::array<Complex, 3>{1.0 / ((m + 1.0) * (m + 1.0)), omega / ((m + 1.0) * (m + 1.0) + omega * omega),
                                  1.0 / std::sqrt(m + 1.0)};
  };
  for (double t = 1e-3; t < 8; t *= 1.7) {
    const auto f = invert_durbin<3>(pairs, t, omega);
    EXPECT_NEAR(f[0], t * std::exp(-t), 1e-10) << t;
    EXPECT_NEAR(f[1], std::exp(-t) * std::sin(omega * t), 1e-10) << t;
    EXPECT_NEAR(f[2], std::exp(-t) / std::sqrt(std::numbers::pi * t), 1e-9 / std::sqrt(t)) << t;
  }
}
}  // namespace
