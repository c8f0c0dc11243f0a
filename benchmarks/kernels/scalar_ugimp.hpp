// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// The honest baseline: one step of uGIMP, USL and FLIP for rate-linear elasticity, as one would write it by hand for
// this one case, a plain loop over particles and their 3^D nodes. No framework, no lanes, no order of the particles.
namespace baseline {

template <int D>
struct ScalarUgimp {
  static constexpr int nodes = D == 2 ? 9 : 27;
  using Vector = std::array<double, D>;
  using Matrix = std::array<Vector, D>;
  struct Node {
    double mass;
    Vector momentum, force;
  };
  struct Weights {
    int node[nodes];
    double w[nodes];
    Vector grad[nodes];
  };

  int cells;
  double half, lambda, mu;  // half size of a particle in cells; the cell is 1 m
  std::vector<Vector> x, v;
  std::vector<Matrix> stress;
  std::vector<double> mass, volume;
  std::vector<Node> grid;

  Weights weights(const Vector& at) const {
    Weights out;
    double w[D][3], d[D][3];
    int first = 0;
    for (int a = 0, stride = 1; a < D; ++a, stride *= cells + 1) {
      const double nearest = std::floor(at[a] + .5), r = at[a] - nearest, t = half - std::clamp(r, -half, half);
      const double below = t * (t + 2 * std::max(0., -half - r)) / (4 * half), slope = -t / (2 * half);
      w[a][0] = below, w[a][1] = 1 - r - 2 * below, w[a][2] = r + below;
      d[a][0] = slope, d[a][1] = -1 - 2 * slope, d[a][2] = 1 + slope;
      first += (int(nearest) - 1) * stride;
    }
    for (int k = 0; k < nodes; ++k) {
      const int i = k % 3, j = k / 3 % 3, l = k / 9;
      const double third = D == 3 ? w[D - 1][l] : 1;
      out.node[k] = first + i + j * (cells + 1) + (D == 3 ? l * (cells + 1) * (cells + 1) : 0);
      out.w[k] = w[0][i] * w[1][j] * third;
      out.grad[k][0] = d[0][i] * w[1][j] * third;
      out.grad[k][1] = w[0][i] * d[1][j] * third;
      if constexpr (D == 3) out.grad[k][2] = w[0][i] * w[1][j] * d[2][l];
    }
    return out;
  }
  void step(double dt) {
    for (Node& n : grid) n = {};
    for (std::size_t p = 0; p < x.size(); ++p) {
      const Weights s = weights(x[p]);
      for (int k = 0; k < nodes; ++k) {
        Node& n = grid[std::size_t(s.node[k])];
        n.mass += s.w[k] * mass[p];
        for (int a = 0; a < D; ++a) {
          double f = 0;
          for (int b = 0; b < D; ++b) f += stress[p][a][b] * s.grad[k][b];
          n.momentum[a] += s.w[k] * mass[p] * v[p][a];
          n.force[a] -= volume[p] * f;
        }
      }
    }
    for (Node& n : grid)
      if (n.mass > 0)
        for (int a = 0; a < D; ++a) n.force[a] *= dt / n.mass, n.momentum[a] = n.momentum[a] / n.mass + n.force[a];
    for (std::size_t p = 0; p < x.size(); ++p) {
      const Weights s = weights(x[p]);
      Matrix L{};
      for (int k = 0; k < nodes; ++k) {
        const Node& n = grid[std::size_t(s.node[k])];
        for (int a = 0; a < D; ++a) {
          x[p][a] += dt * s.w[k] * n.momentum[a];
          v[p][a] += s.w[k] * n.force[a];
          for (int b = 0; b < D; ++b) L[a][b] += n.momentum[a] * s.grad[k][b];
        }
      }
      double trace = 0;
      for (int a = 0; a < D; ++a) trace += L[a][a];
      volume[p] *= 1 + dt * trace;
      const Matrix old = stress[p];
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) {
          double turned = 0;
          for (int c = 0; c < D; ++c)
            turned += .5 * ((L[a][c] - L[c][a]) * old[c][b] - old[a][c] * (L[c][b] - L[b][c]));
          stress[p][a][b] += dt * (turned + mu * (L[a][b] + L[b][a]) + (a == b ? lambda * trace : 0));
        }
    }
  }
};

}  // namespace baseline
