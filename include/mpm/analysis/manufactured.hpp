// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/materials/elastic_moduli.hpp>
#include <mpm/materials/neo_hookean.hpp>
#include <mpm/tensor.hpp>
#include <Eigen/Core>
#include <cmath>
#include <numbers>

// Manufactured solutions: a motion is chosen and the body force b (m/s2) found that drives a neo-Hookean solid through
// it, rho0 u_tt = Div P + rho0 b. All take the reference position X (m) and the time t (s). Each carries the `material`
// its body force belongs to; run exactly that one.
namespace mpm::analysis {

/// A place or a vector in D dimensions.
template <int D>
using Point = Eigen::Matrix<double, D, 1>;

/// Axis-aligned displacement of the unit interval, square or cube (Wallstedt & Guilkey 2008, J. Comput. Phys. 227,
/// 9628): u_k = A sin(pi X_k) sin(pi (phi_k + c t)), phi = 0, 2/3, 4/3, c = sqrt(E/rho0). The faces keep their normal
/// position; from the second axis on the body is strained at t = 0 already.
template <int D>
struct AxisAligned {
  static_assert(D >= 1 && D <= 3, "AxisAligned: 1, 2 or 3 dimensions");
  NeoHookean material{.density = 1, .young = 1e4, .poisson = .3};
  double amplitude{0.05};  ///< A, m; below 1/pi, or the body turns inside out

  /// m.
  Point<D> displacement(const Point<D>& X, double t) const {
    return per_axis([&](int k) { return amplitude * std::sin(pi * X[k]) * std::sin(phase(k, t)); });
  }
  /// m/s.
  Point<D> velocity(const Point<D>& X, double t) const {
    return per_axis([&](int k) { return amplitude * pi * speed() * std::sin(pi * X[k]) * std::cos(phase(k, t)); });
  }
  Tensor<double> deformation_gradient(const Point<D>& X, double t) const {
    const auto diagonal = [&](int k) { return k < D ? stretch(X[k], k, t) : 1; };
    return {diagonal(0), 0, 0, 0, diagonal(1), 0, 0, 0, diagonal(2)};
  }
  /// m/s2.
  Point<D> body_force(const Point<D>& X, double t) const {
    const double lambda = lame_modulus(material.young, material.poisson), mu = shear();
    const Point<D> u = displacement(X, t);
    const double log_J = std::log(determinant(deformation_gradient(X, t)));
    return per_axis([&](int k) {
      const double F = stretch(X[k], k, t);
      return pi * pi * u[k] *
             (mu / material.density - speed() * speed() - (lambda * (log_J - 1) - mu) / (material.density * F * F));
    });
  }

 private:
  static constexpr double pi = std::numbers::pi;
  double shear() const { return shear_modulus(material.young, material.poisson); }
  double speed() const { return std::sqrt(material.young / material.density); }
  double phase(int axis, double t) const { return pi * (2. / 3 * axis + speed() * t); }
  double stretch(double x, int axis, double t) const {
    return 1 + pi * amplitude * std::cos(pi * x) * std::sin(phase(axis, t));
  }
  template <class Component>
  static Point<D> per_axis(const Component& component) {
    Point<D> v;
    for (int k = 0; k < D; ++k) v[k] = component(k);
    return v;
  }
};

/// Generalized vortex (Kamojjala et al. 2015, Engineering with Computers 31): every circle of the ring inner <= R <=
/// outer turns rigidly by alpha = A sin(pi c t) (1 - 32 (R-1)^2 + 256 (R-1)^4), c = sqrt(E/rho0), the rims staying
/// where they are. Plane strain, no change of volume, shears up to 6 to 7.
struct Vortex {
  static constexpr double inner = .75, outer = 1.25;  ///< m
  NeoHookean material{.density = 1000, .young = 1000, .poisson = .3};
  double amplitude{1};  ///< A, rad

  /// m.
  Point<2> displacement(const Point<2>& X, double t) const { return turned(X, turn(X.norm(), t).angle) - X; }
  /// m/s.
  Point<2> velocity(const Point<2>& X, double t) const {
    const Turn a = turn(X.norm(), t);
    return a.rate * turned(normal(X), a.angle);
  }
  Tensor<double> deformation_gradient(const Point<2>& X, double t) const {
    const Turn a = turn(X.norm(), t);
    const Point<2> shear = a.slope * turned(normal(X), a.angle), r = X.normalized();
    const double c = std::cos(a.angle), s = std::sin(a.angle);
    return {c + shear[0] * r[0], -s + shear[0] * r[1], 0, s + shear[1] * r[0], c + shear[1] * r[1], 0, 0, 0, 1};
  }
  /// m/s2. Two public input decks have a sign of it wrong; this one obeys the balance of momentum.
  Point<2> body_force(const Point<2>& X, double t) const {
    const double R = X.norm(), s = shear_modulus(material.young, material.poisson) / material.density;
    const Turn a = turn(R, t);
    const double radial = R * (s * a.slope * a.slope - a.rate * a.rate);
    const double hoop = R * a.acceleration - s * (3 * a.slope + R * a.curvature);
    return turned((radial * X + hoop * normal(X)) / R, a.angle);
  }

 private:
  /// alpha, its derivatives in time (rate, acceleration) and along R (slope, curvature).
  struct Turn {
    double angle, rate, acceleration, slope, curvature;
  };
  Turn turn(double R, double t) const {
    const double w = std::numbers::pi * std::sqrt(material.young / material.density), d = R - 1, q = 1 - 16 * d * d;
    const double g = amplitude * std::sin(w * t), h = q * q;
    return {g * h, amplitude * w * std::cos(w * t) * h, -w * w * g * h, -64 * d * q * g, -64 * (1 - 48 * d * d) * g};
  }
  static Point<2> normal(const Point<2>& v) { return {-v[1], v[0]}; }
  static Point<2> turned(const Point<2>& v, double angle) { return std::cos(angle) * v + std::sin(angle) * normal(v); }
};

/// Expanding ring with free rims (Wallstedt & Guilkey 2008): radial displacement A sin(pi c t/(ro + ri))
/// (c1 R + c2 R^2 + c3 R^3), c = sqrt(E/rho0), which is A at the outer rim and strains neither rim radially. Plane
/// strain; nu = 0, without which the rims would need tractions.
struct ExpandingRing {
  static constexpr NeoHookean material{.density = 1000, .young = 1e7, .poisson = 0};
  double inner{.4}, outer{.6};  ///< ri, ro, m
  double amplitude{.1};         ///< A, m

  /// m.
  Point<2> displacement(const Point<2>& X, double t) const { return sine(t) * profile(X.norm()).u * X.normalized(); }
  /// m/s.
  Point<2> velocity(const Point<2>& X, double t) const {
    return frequency() * std::cos(frequency() * t) * profile(X.norm()).u * X.normalized();
  }
  Tensor<double> deformation_gradient(const Point<2>& X, double t) const {
    const Point<2> r = X.normalized();
    const Stretch f = stretch(X.norm(), t);
    const double shear = (f.radial - f.hoop) * r[0] * r[1];
    return {f.hoop + (f.radial - f.hoop) * r[0] * r[0],
            shear,
            0,
            shear,
            f.hoop + (f.radial - f.hoop) * r[1] * r[1],
            0,
            0,
            0,
            1};
  }
  /// m/s2.
  Point<2> body_force(const Point<2>& X, double t) const {
    const double R = X.norm(), mu = shear_modulus(material.young, material.poisson);
    const Stretch f = stretch(R, t);
    const auto stress = [&](double f_kk) { return mu * (f_kk - 1 / f_kk); };  // P_rr or P_tt, nu = 0
    const double divergence =
        mu * (1 + 1 / (f.radial * f.radial)) * f.radial_slope + (stress(f.radial) - stress(f.hoop)) / R;
    const double acceleration = -frequency() * frequency() * sine(t) * profile(R).u;
    return (acceleration - divergence / material.density) * X.normalized();
  }

 private:
  /// A (c1 R + c2 R^2 + c3 R^3) and its derivatives.
  struct Profile {
    double u, slope, curvature;
  };
  /// Principal stretches and d(radial)/dR.
  struct Stretch {
    double radial, hoop, radial_slope;
  };
  Profile profile(double R) const {
    const double scale = amplitude / (outer * outer * (outer - 3 * inner));
    const double c1 = -6 * inner * outer * scale, c2 = 3 * (outer + inner) * scale, c3 = -2 * scale;
    return {R * (c1 + R * (c2 + R * c3)), c1 + R * (2 * c2 + R * 3 * c3), 2 * c2 + 6 * c3 * R};
  }
  Stretch stretch(double R, double t) const {
    const Profile p = profile(R);
    return {1 + sine(t) * p.slope, 1 + sine(t) * p.u / R, sine(t) * p.curvature};
  }
  double frequency() const { return std::numbers::pi * std::sqrt(material.young / material.density) / (outer + inner); }
  double sine(double t) const { return std::sin(frequency() * t); }
};

}  // namespace mpm::analysis
