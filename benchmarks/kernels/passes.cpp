// SPDX-License-Identifier: MIT
#include "step.hpp"

// The passes between particles and grid, each beside its plain form: momentum, mass and forces to the nodes, with the
// stable step found or not; velocity, strain and stress back. By number of particles, particles an edge, layout and
// threads.
namespace kernels {
namespace {

template <class Shape, class S>
struct Pass {
  Body<Shape, Hypoelastic, S> body;
  Grid<S> grid;
  Transfer<Body<Shape, Hypoelastic, S>, Usl> transfer;

  explicit Pass(const benchmark::State& state) : body(block_of(state)), grid(Vector<S>::Zero(), 1, cells_of(state)) {
    program::use_threads(int(state.range(3)));
    transfer.locate(body, grid);
    if (Layout(state.range(2)) != Layout::drifted) return;
    for (std::size_t p = 0; p < body.size(); ++p) body.x(0)[p] += .2;
    if constexpr (requires { body.shape.corner; })
      for (auto& x : body.shape.corner) x[0] += .2;
    transfer.locate(body, grid);
  }
  void report(benchmark::State& state) const {
    state.SetItemsProcessed(state.iterations() * std::int64_t(body.size()));
    state.counters["bytes"] = double(body.bytes_per_particle);
  }

 private:
  static int edge(const benchmark::State& state) { return cells_for<S>(int(state.range(1)), double(state.range(0))); }
  static Body<Shape, Hypoelastic, S> block_of(const benchmark::State& state) {
    return block<Shape, Hypoelastic, S>(edge(state), int(state.range(1)), Layout(state.range(2)), {});
  }
  static std::array<int, S::dimension> cells_of(const benchmark::State& state) {
    std::array<int, S::dimension> count;
    count.fill(edge(state) + 4);
    return count;
  }
};

template <class Shape, class S>
void scatter(benchmark::State& state) {
  Pass<Shape, S> c(state);
  for (auto _ : state)
    c.transfer.template scatter<What::momentum_and_forces>(c.body, c.grid, c.grid.velocity, UniformBodyForce<S>{}, 0);
  c.report(state);
}
/// The same, and the largest stable step, of particles that a step has moved at 1/1000 m/s for a time `dt`: in 10 s
/// too far for anything to be kept.
template <class Shape, class S>
void scatter_and_step(benchmark::State& state, double dt) {
  Pass<Shape, S> c(state);
  for (auto& v : c.grid.velocity) v.setConstant(1e-3);
  c.transfer.template update<true, Strained::by_first, true>(c.body, c.grid, Usl{}, 0, dt);
  for (auto _ : state) {
    c.transfer.template scatter<What::momentum_and_forces, true>(c.body, c.grid, c.grid.velocity, UniformBodyForce<S>{},
                                                                 0);
    benchmark::DoNotOptimize(c.transfer.stable_step(c.body, c.grid));
  }
  c.report(state);
}
/// How stiff the grid is with shared masses, which a calm body finds anew every 512 steps at most.
template <class Shape, class S>
void share_masses(benchmark::State& state) {
  Pass<Shape, S> c(state);
  ParticleOrder order;
  locate(c.body, c.grid, order);
  CalmStiffness<Body<Shape, Hypoelastic, S>> calm;
  for (auto _ : state) calm.find(c.body, order, c.grid);
  c.report(state);
}
template <class Shape, class S>
void plain_scatter(benchmark::State& state) {
  Pass<Shape, S> c(state);
  ParticleOrder order;
  locate(c.body, c.grid, order);
  for (auto _ : state)
    for_each_coloured(order, [&](std::size_t p) {
      scatter_plainly<What::momentum_and_forces>(c.body, p, c.grid, c.grid.velocity, UniformBodyForce<S>{}, 0);
    });
  c.report(state);
}
template <class Shape, class S>
void update(benchmark::State& state) {
  Pass<Shape, S> c(state);
  for (auto _ : state) c.transfer.template update<true, Strained::by_first, true>(c.body, c.grid, Usl{}, 0, 0);
  c.report(state);
}
template <class Shape, class S>
void plain_update(benchmark::State& state) {
  Pass<Shape, S> c(state);
  constexpr bool move = Shape::domain_motion != DomainMotion::corners;
  const ChunkList all(c.body.size());
  std::vector<StrainWork> partial;
  std::vector<StepLimits<double>> limits;
  for (auto _ : state) {
    gather_velocity(c.body, all, c.grid, Usl{});
    update_stress<move>(c.body, all, c.grid, c.grid.velocity, OwnDilatation{}, 1., 0., 0., partial, limits);
  }
  c.report(state);
}

template <class F>
void add_pass(const std::string& name, const F& f) {
  auto* pass = benchmark::RegisterBenchmark(name.c_str(), f);
  pass->ArgNames({"particles", "an edge", "layout", "threads"})->UseRealTime();
  constexpr auto regular = std::int64_t(Layout::regular);
  for (const int particles : {10000, usual_count, 1000000}) pass->Args({particles, 2, regular, 1});
  for (const int an_edge : {4, 20}) pass->Args({usual_count, an_edge, regular, 1});
  for (const Layout layout : {Layout::jittered, Layout::shuffled, Layout::drifted})
    pass->Args({usual_count, 2, std::int64_t(layout), 1});
  pass->Args({usual_count, 2, regular, 2});
}

template <class Shape, class S = PlaneStrain<>>
void add_passes_of(const std::string& shape) {
  add_pass("scatter, " + shape, scatter<Shape, S>);
  add_pass("scatter and stable step, " + shape, [](benchmark::State& s) { scatter_and_step<Shape, S>(s, 0); });
  if constexpr (Foreseeable<Body<Shape, Hypoelastic, S>>) {
    add_pass("scatter and stable step, on the move, " + shape,
             [](benchmark::State& s) { scatter_and_step<Shape, S>(s, 10); });
    add_pass("shared masses, " + shape, share_masses<Shape, S>);
  }
  add_pass("scatter, plain, " + shape, plain_scatter<Shape, S>);
  add_pass("update, " + shape, update<Shape, S>);
  add_pass("update, plain, " + shape, plain_update<Shape, S>);
}

}  // namespace

void add_passes() {
  add_passes_of<Linear>("linear");
  add_passes_of<Ugimp>("uGIMP");
  add_passes_of<Cpgimp>("cpGIMP");
  add_passes_of<QuadraticBspline>("quadratic B-spline");
  add_passes_of<CubicBspline>("cubic B-spline");
  add_passes_of<Cpdi>("CPDI R4");
  add_passes_of<CpdiQuad>("CPDI2");
  add_passes_of<Ugimp, Uniaxial<>>("uGIMP, 1-D");
  add_passes_of<Ugimp, Spatial<>>("uGIMP, 3-D");
}

}  // namespace kernels
