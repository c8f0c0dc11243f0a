// SPDX-License-Identifier: MIT
#pragma once
#include "block.hpp"
#include <program/threads.hpp>
#include <memory>
#include <string>
#include <utility>

// Whole steps by method. One file for each group of methods, as each user compiles a few.
namespace kernels {

constexpr int usual_count = 100000;

/// What is timed, beside the types.
template <class Law, class Integrator>
struct Case {
  int per_edge = 2, particles = usual_count;
  Law law{};
  Integrator integrator{};
  bool damaging = false;   ///< sheared until every particle yields
  double drift = 0;        ///< velocity along x, as a share of the elastic wave's: particles change cells
  int steps_between = 60;  ///< a block that moves is made anew, or it would leave the grid while it is timed
  int threads = 1;
  int room = 1;  ///< edge of the grid, in those of the block
  std::vector<Layout> layouts{Layout::regular, Layout::jittered};
};

template <class Shape, class Integrator, class S, class Law>
void step(benchmark::State& state, const Case<Law, Integrator>& c) {
  program::use_threads(c.threads);
  const int cells = cells_for<S>(c.per_edge, c.particles);
  std::array<int, S::dimension> count;
  count.fill(c.room * (cells + 4));
  const Grid<S> grid(Vector<S>::Zero(), 1, count);
  auto body = block<Shape, Law, S>(cells, c.per_edge, Layout(state.range(0)), c.law);
  if (c.damaging)
    for (std::size_t p = 0; p < body.size(); ++p) body.v(0)[p] = .5 * body.x(1)[p], body.history(0)[p] = .3;
  if (c.drift > 0) {
    const double speed =
        std::sqrt(c.law.template tangent<double>(c.law.template initial<double>(), 1.).longitudinal / c.law.density);
    for (std::size_t p = 0; p < body.size(); ++p) body.v(0)[p] += typename S::Scalar(c.drift * speed);
  }
  state.counters["bytes"] = double(body.bytes_per_particle);
  state.counters["flops"] = transfer_flops(body, grid);
  using SolverT = Solver<Shape, Law, Integrator, S>;
  std::unique_ptr<SolverT> solver;
  int left = 0;
  for (auto _ : state) {
    if (left-- == 0) {
      state.PauseTiming();
      solver = std::make_unique<SolverT>(grid, body);
      solver->integrator = c.integrator;
      for (int k = 0; k < (c.damaging ? 40 : 3); ++k) solver->step();
      left = c.steps_between - 1;
      state.ResumeTiming();
    }
    solver->step();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(body.size()));
}

/// Registers a row of the table; S::dimension == 3 compares with the plain loop in space.
template <class Shape, class Law, class Integrator, class S = PlaneStrain<>>
void add(const std::string& name, const Case<Law, Integrator>& c = {}) {
  auto* row =
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) { step<Shape, Integrator, S>(s, c); });
  row->ArgName("layout")->UseRealTime();
  for (const Layout layout : c.layouts) row->Arg(std::int64_t(layout));
}

void add_ugimp();
void add_splines();
void add_domains();
void add_laws();
void add_space();
void add_blast();
void add_passes();

}  // namespace kernels
