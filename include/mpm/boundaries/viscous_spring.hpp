// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/boundaries/quiet.hpp>
#include <mpm/error.hpp>
#include <cmath>

namespace mpm {

/// Non-reflecting face that knows where the waves come from: springs beside the dashpots of Quiet, in the manner of
/// Deeks & Randolph 1994, J. Eng. Mech. 120, 25, on faces that need not be normal to the radius.
///
/// What a dashpot reflects of a pulse from a cavity is the slow, nearly static field behind the front. A wave that
/// leaves `centre` spreads in N directions across the radius (cylinder 1, sphere 2) and has
///   du_r/dr = -v_r/c_p - N (u_r + w)/(2 r),   dw/dt = kappa (c_p/r) (u_r - w),
/// w lagging behind u_r: u_r falls as r^(-N/2) at the front and as r^-N at rest. For a sphere this is exact with
/// kappa = 1. For a cylinder it stands for K0(z)/K1(z) = 1 - 1/(2 (z + kappa)), z = s r/c_p, in the Laplace domain, and
/// kappa = 2/3 is within 2.5 % from z = 1/2 on. With e = x/r and the N strains u_r/r Hooke's law gives the traction
///   sigma n = -(lambda n + 2 mu (e.n) e) v_r/c_p + [(lambda N/2 + 2 mu) n - mu (2 + N) (e.n) e] u_r/r
///             -N (lambda/2 n + mu (e.n) e) w/r.
/// Motion across the radius meets a dashpot rho c_s (e.n). A node's force is R0 + A sigma n, as in Quiet solved
/// implicitly, so that it never limits the step; u_r is what the node has moved since the face turned quiet.
///
/// One centre a face: of several charges the nearest, or the middle of them. It must lie on the bodies' side of the
/// face, and in the plane of a face with rollers that meets this one.
template <Space S>
struct ViscousSpring : Quiet<S> {
  using Scalar = typename S::Scalar;

  Moduli<Scalar> moduli{};               ///< Pa
  Vector<S> centre = Vector<S>::Zero();  ///< m
  std::vector<Scalar> displacement{};    ///< u_r in the order of the face's nodes, m
  std::vector<Scalar> lagging{};         ///< w, likewise

  /// For an isotropic solid.
  static ViscousSpring from(Scalar density, const Moduli<Scalar>& moduli, const Vector<S>& centre) {
    ViscousSpring result;
    static_cast<Quiet<S>&>(result) = Quiet<S>::from(density, moduli);
    result.moduli = moduli;
    result.centre = centre;
    return result;
  }
  /// Throws Error where the centre does not lie on the bodies' side of the face.
  void absorb(Grid<S>& grid, int axis, int side, Scalar dt) {
    const std::size_t nodes = grid.size() / (std::size_t(grid.cells(axis)) + 1);
    displacement.resize(nodes, 0);
    lagging.resize(nodes, 0);
    std::size_t k = 0;
    grid.for_each_on_face(axis, side, [&](int node, const auto& index) {
      const std::size_t at = k++;
      if (!(grid.mass[node] > 0)) return;
      const Scalar area = tributary_area(grid, axis, index), w = lagging[at];
      const Response response = respond(grid.position(node), axis, side);
      const Vector<S> v = response.advance(grid.velocity[node], displacement[at], w, grid.mass[node] / area, dt);
      displacement[at] += dt * response.e.dot(v);
      lagging[at] = (w + dt * response.rate * displacement[at]) / (1 + dt * response.rate);
      grid.increment[node] += v - grid.velocity[node];
      grid.velocity[node] = v;
      Vector<S> force = area * response.traction(v, displacement[at], w);
      if (!this->reaction.empty()) force += this->reaction[at];
      this->work += double(dt * force.dot(v - Scalar(0.5) * grid.increment[node]));
    });
  }

 private:
  static constexpr int spread = S::dimension - 1 + int(S::hoop);  ///< N
  static constexpr Scalar kappa = spread == 2 ? Scalar(1) : Scalar(2) / 3;

  /// sigma n = -dashpot v_r - spring u_r - late w - across (v - v_r e).
  struct Response {
    Vector<S> e, dashpot, spring, late;
    Scalar across, rate;

    Vector<S> traction(const Vector<S>& v, Scalar u, Scalar w) const {
      const Scalar radial = e.dot(v);
      return -(radial * dashpot + u * spring + w * late + across * (v - radial * e));
    }
    /// v+ with m v+ = m v + dt sigma n (v+, u + dt v_r+, w), m the mass an area: first v_r+, which the rest follows.
    Vector<S> advance(const Vector<S>& v, Scalar u, Scalar w, Scalar m, Scalar dt) const {
      const Vector<S> implicit = dt * (dashpot + dt * spring), pushed = m * v - dt * (u * spring + w * late);
      const Scalar radial = e.dot(pushed) / (m + e.dot(implicit));
      const Vector<S> rest = pushed - radial * implicit;
      return radial * e + (rest - e.dot(rest) * e) / (m + dt * across);
    }
  };
  Response respond(const Vector<S>& x, int axis, int side) const {
    Vector<S> n = Vector<S>::Zero();
    n[axis] = side == 0 ? Scalar(-1) : Scalar(1);
    if (!(n.dot(x - centre) > 0))
      throw Error("mpm::ViscousSpring: the centre of the waves must lie on the bodies' side of the quiet face");
    const Scalar r = (x - centre).norm(), mu = moduli.shear, lambda = moduli.longitudinal - 2 * mu;
    const Scalar speed = moduli.longitudinal / this->normal_impedance, N = Scalar(spread);
    const Vector<S> e = (x - centre) / r, along = e.dot(n) * e;
    return {.e = e,
            .dashpot = (lambda * n + 2 * mu * along) / speed,
            .spring = N > 0 ? ((mu * (2 + N) * along - (lambda * N / 2 + 2 * mu) * n) / r).eval() : Vector<S>::Zero(),
            .late = N * (lambda / 2 * n + mu * along) / r,
            .across = e.dot(n) * this->tangential_impedance,
            .rate = kappa * speed / r};
  }
};

}  // namespace mpm
