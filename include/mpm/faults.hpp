// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/chunk_list.hpp>
#include <mpm/error.hpp>
#include <mpm/passes/stable_step.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

// What no step can start from or end with, and the Error that names body, particle, position, step and remedy.
namespace mpm {

/// When a fault is found.
struct Moment {
  std::int64_t step;
  double time;  ///< s
};

/// Throws the Error of particle `p`: its body, position, what is wrong with it, when, and the remedy.
template <class B>
[[noreturn]] void fail_particle(const B& b, std::size_t p, const Moment& now, const std::string& what,
                                const char* remedy) {
  std::ostringstream text;
  text << "particle " << p << " of " << b.name << " at (";
  for (int d = 0; d < B::dimension; ++d) text << (d ? ", " : "") << b.x(d)[p];
  text << ") m " << what << ", in step " << now.step << " at " << now.time << " s: " << remedy;
  throw Error(text.str());
}

/// Throws Error when the shape's parameters do not fit the grid, or the law has no stiffness at rest.
template <class B, class S>
void check_policies(const B& b, const Grid<S>& grid) {
  using Scalar = typename S::Scalar;
  if (b.size() == 0) return;
  if constexpr (requires { b.shape.check(b, grid); }) b.shape.check(b, grid);
  const auto moduli = b.law.tangent(b.law.template initial<Scalar>(), Scalar(1));
  if (std::isfinite(moduli.longitudinal) && moduli.longitudinal >= 0 && moduli.shear >= 0) return;
  std::ostringstream text;
  text << "body " << b.name << ": the law's stiffness at rest is no finite positive number (longitudinal "
       << moduli.longitudinal << " Pa, shear " << moduli.shear
       << " Pa); look at its moduli, and keep Poisson's ratio between -1 and 0.5";
  throw Error(text.str());
}

/// First particle of `chunks` that no step can start from, or size(): outside the grid by more than half a cell, or
/// nowhere; without volume; with a velocity that is no finite number.
template <class B, class S>
std::size_t first_unfit(const B& b, const Grid<S>& grid, const ChunkList& chunks) {
  using V = typename B::Lane;
  const auto margin = grid.cell() / 2;
  return chunks.least(chunks.entries(), [&](std::size_t first, int count) {
    std::size_t bad = b.size();
    for (int l = 0; l < count; l += V::size) {
      const std::size_t p = first + std::size_t(l);
      auto fit = V::load(b.volume() + p) > V(0);
      for (int d = 0; d < S::dimension; ++d) {
        const V x = V::load(b.x(d) + p);
        fit = fit && x >= V(grid.origin()[d] - margin) && x <= V(grid.upper(d) + margin) &&
              V(0) * V::load(b.v(d) + p) <= V(0);
      }
      if (any(!fit))
        for (int k = 0; k < std::min(V::size, count - l); ++k)
          if (!fit.v[k]) bad = std::min(bad, p + std::size_t(k));
    }
    return bad;
  });
}
template <class B, class S>
[[noreturn]] void fail_unfit(const B& b, std::size_t p, const Grid<S>& grid, const Moment& now) {
  const auto margin = grid.cell() / 2;
  for (int d = 0; d < S::dimension; ++d)
    if (!(b.x(d)[p] >= grid.origin()[d] - margin && b.x(d)[p] <= grid.upper(d) + margin))
      fail_particle(b, p, now, "has left the grid", "enlarge the grid, or close its faces with walls");
  if (!(b.volume()[p] > 0))
    fail_particle(b, p, now, "has a volume that is not positive", "lower `safety`, or refine the grid there");
  fail_particle(b, p, now, "has a velocity that is no finite number",
                "look at its stress in the last snapshot, and lower `safety`");
}

/// Throws Error on the first particle whose stiffness is no finite positive number.
template <class B>
void blame_stiffness(const B& b, const Moment& now) {
  for (std::size_t p = 0; p < b.size(); ++p) {
    const auto moduli = b.law.tangent(b.state(p), b.relative_volume(p));
    if (!std::isfinite(moduli.longitudinal + moduli.shear) || !(moduli.longitudinal >= 0))
      fail_particle(b, p, now, "allows no stable step, since its stiffness is no finite positive number",
                    "look at its stress in the last snapshot, and lower `safety`");
  }
}

/// Throws Error on a particle that allows no more than `dt`, s, which is less than `floor` of the first step.
template <class B, class S>
[[noreturn]] void fail_short(const B& b, std::size_t p, const Grid<S>& grid, typename S::Scalar dt,
                             typename S::Scalar floor, const Moment& now) {
  using Scalar = typename S::Scalar;
  const auto L = velocity_gradient<S>(make_stencil(b, p, grid), grid.velocity, b.x(0)[p]);
  const Scalar speed = b.velocity(p).cwiseAbs().maxCoeff(), rate = std::sqrt(inner(symmetric(L), symmetric(L)));
  const char* remedy = "look at its law, or take a shape whose weights do not vanish at a node, such as mpm::Ugimp";
  std::ostringstream what;
  what << "allows a step of " << dt << " s, less than " << floor << " of the first (`step_floor`), as it ";
  if (speed * dt >= Scalar(0.49) * grid.cell()) {
    what << "moves at " << speed << " m/s";
    remedy = "look for what drives it in the last snapshot, and lower `safety`";
  } else if (rate * dt >= Scalar(0.099)) {
    what << "is strained at " << rate << " 1/s";
    remedy = "lower `safety`, or take an integrator that filters velocities, such as mpm::Fmpm";
  } else {
    what << "has a stiffness of " << b.law.tangent(b.state(p), b.relative_volume(p)).longitudinal
         << " Pa and touches the grid as it does";
  }
  fail_particle(b, p, now, what.str(), remedy);
}

}  // namespace mpm
