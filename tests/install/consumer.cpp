// SPDX-License-Identifier: MIT
// A user's program: one include, a few steps, a number. An optimiser that got the step wrong would show here.
#include <mpm/mpm.hpp>
#include <cmath>
#include <cstdio>

template <class Shape>
double height_after_fall() {
  mpm::Body<Shape, mpm::NeoHookean> ball{"ball", {}, {.density = 1000, .young = 1e5, .poisson = .3}};
  const auto inside = [](const auto& x) { return std::hypot(x[0] - .5, x[1] - .5) < .3; };
  mpm::fill(ball, {0, 0}, {1, 1}, .05, inside, {.1, 0});
  mpm::Solver<Shape, mpm::NeoHookean, mpm::Musl> solver{mpm::Grid<mpm::PlaneStrain<>>{{0, 0}, .1, {10, 10}}, ball};
  solver.boundary.face(1, 0) = mpm::Rollers<mpm::PlaneStrain<>>{};
  solver.body_force = {0, -10};
  solver.run(.4);
  double height = 0;
  for (std::size_t p = 0; p < ball.size(); ++p) height += solver.body().x(1)[p] / double(ball.size());
  return height;
}

int main() {
  std::printf("mean height after the bounce: %.3f %.3f %.3f m\n", height_after_fall<mpm::Linear>(),
              height_after_fall<mpm::Ugimp>(), height_after_fall<mpm::Cpgimp>());
}
