// SPDX-License-Identifier: MIT
#include <mpm/mpm.hpp>
#include <mpm/materials/hypoelastic.hpp>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <random>

// The passes between particles and grid, one benchmark a pass and shape and its plain twin beside it, on one block of
// elastic rock in plane strain: momentum, mass and forces to the nodes; velocity, strain and stress back.
// items_per_second is particles a second; `bytes` is what a particle costs in memory.
namespace {

using namespace mpm;
using Space = PlaneStrain<>;

/// A block of `edge` cells a side with `per_edge` particles along each cell edge, jittered by a quarter of a cell.
template <class Shape>
Body<Shape, Hypoelastic> block(int edge, int per_edge) {
  Body<Shape, Hypoelastic> body("block", {}, {});
  const double size = 1.0 / per_edge;
  const int n = edge * per_edge;
  if constexpr (requires { body.shape.half_size; }) body.shape.half_size = {size / 2, size / 2};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.25, 0.25);
  if constexpr (requires { body.shape.corner; }) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) body.shape.corner.push_back({2 + i * size, 2 + j * size});
    const auto at = [&](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) add_quad(body, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  } else {
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        body.add({2 + (i + 0.5) * size + jitter(random), 2 + (j + 0.5) * size + jitter(random)}, size * size, {1, 0});
  }
  return body;
}

template <class Shape>
struct Case {
  int edge;
  Body<Shape, Hypoelastic> body;
  Grid<Space> grid;
  Transfer<Body<Shape, Hypoelastic>, Usl> transfer;

  explicit Case(const benchmark::State& state)
      : edge(int(state.range(0))),
        body(block<Shape>(edge, int(state.range(1)))),
        grid({0, 0}, 1, {edge + 4, edge + 4}) {
    transfer.locate(body, grid);
  }
  void report(benchmark::State& state) const {
    state.SetItemsProcessed(state.iterations() * std::int64_t(body.size()));
    state.counters["bytes"] = double(body.bytes_per_particle);
  }
};

template <class Shape>
void scatter(benchmark::State& state) {
  Case<Shape> c(state);
  for (auto _ : state)
    c.transfer.template scatter<What::momentum_and_forces>(c.body, c.grid, c.grid.velocity, UniformBodyForce<Space>{},
                                                           0);
  c.report(state);
}
template <class Shape>
void plain_scatter(benchmark::State& state) {
  Case<Shape> c(state);
  ParticleOrder order;
  locate(c.body, c.grid, order);
  for (auto _ : state)
    for_each_coloured(order, [&](std::size_t p) {
      scatter_plainly<What::momentum_and_forces>(c.body, p, c.grid, c.grid.velocity, UniformBodyForce<Space>{}, 0);
    });
  c.report(state);
}
template <class Shape>
void update(benchmark::State& state) {
  Case<Shape> c(state);
  for (auto _ : state) c.transfer.template update<true, Strained::by_first, true>(c.body, c.grid, Usl{}, 0, 0);
  c.report(state);
}
template <class Shape>
void plain_update(benchmark::State& state) {
  Case<Shape> c(state);
  constexpr bool move = Shape::domain_motion != DomainMotion::corners;
  const ChunkList all(c.body.size());
  std::vector<double> partial;
  std::vector<StepLimits<double>> limits;
  for (auto _ : state) {
    gather_velocity(c.body, all, c.grid, Usl{});
    update_stress<move>(c.body, all, c.grid, c.grid.velocity, 1., 0., 0., partial, limits);
  }
  c.report(state);
}
template <class Shape>
void step(benchmark::State& state) {
  Case<Shape> c(state);
  Solver<Shape, Hypoelastic, Usl> solver(c.grid, std::move(c.body));
  for (auto _ : state) solver.step();
  c.body = std::move(solver.body());
  c.report(state);
}

#define MPM_BENCHMARK_PASS(pass, Shape) \
  BENCHMARK_TEMPLATE(pass, Shape)->ArgsProduct({{100}, {2, 4, 20}})->ArgNames({"cells", "edge"})
#define MPM_BENCHMARK_SHAPE(Shape)          \
  MPM_BENCHMARK_PASS(plain_scatter, Shape); \
  MPM_BENCHMARK_PASS(scatter, Shape);       \
  MPM_BENCHMARK_PASS(plain_update, Shape);  \
  MPM_BENCHMARK_PASS(update, Shape);        \
  MPM_BENCHMARK_PASS(step, Shape)

MPM_BENCHMARK_SHAPE(Linear);
MPM_BENCHMARK_SHAPE(Ugimp);
MPM_BENCHMARK_SHAPE(Cpgimp);
MPM_BENCHMARK_SHAPE(QuadraticBspline);
MPM_BENCHMARK_SHAPE(CubicBspline);
MPM_BENCHMARK_SHAPE(Cpdi);
MPM_BENCHMARK_SHAPE(CpdiQuad);

}  // namespace

BENCHMARK_MAIN();
