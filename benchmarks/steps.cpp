// SPDX-License-Identifier: MIT
#include "scalar_ugimp.hpp"
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
#include <benchmark/benchmark.h>
#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <string>

// Whole steps, locating and sorting included, by method, against the plain scalar loop of scalar_ugimp.hpp in the same
// run: a block of 2 particles a cell edge, regular, and with positions jittered by a quarter of a cell.
// items_per_second is particle-steps a second, `bytes` what a particle holds. Ends with the table of ratios.
//
// Blocks that move are made anew every so many steps, or they would leave the grid while they are timed.
namespace {

using namespace mpm;

constexpr int usual_count = 100000;

/// Cells along the edge of a block of about `particles`.
template <class S>
int cells_for(int per_edge, double particles = usual_count) {
  return int(std::pow(particles, 1. / S::dimension) / per_edge);
}

template <class Shape, class Law, class S>
Body<Shape, Law, S> block(int cells, int per_edge, bool jittered, const Law& law) {
  using Scalar = typename S::Scalar;
  Body<Shape, Law, S> body("block", {}, law);
  Vector<S> lower = Vector<S>::Constant(2), upper = Vector<S>::Constant(Scalar(2 + cells));
  fill(body, lower, upper, Scalar(1) / Scalar(per_edge));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-.25, .25);
  for (std::size_t p = 0; p < body.size(); ++p)
    for (int d = 0; d < S::dimension; ++d) {
      if (jittered && Shape::domain_motion != DomainMotion::corners) body.x(d)[p] += Scalar(offset(random));
      body.v(d)[p] = Scalar(1e-3 * std::sin(double(body.x(d)[p])));
    }
  if constexpr (requires { body.shape.corner; })
    if (jittered)
      for (auto& x : body.shape.corner)
        for (double& y : x) y += .4 * offset(random) / per_edge;
  return body;
}

/// What is timed, beside the types.
template <class Law, class Integrator>
struct Case {
  int per_edge = 2, particles = usual_count;
  Law law{};
  Integrator integrator{};
  bool damaging = false;  ///< sheared until every particle yields
  int steps_between = 60;
};

template <class Shape, class Integrator, class S, class Law>
void step(benchmark::State& state, const Case<Law, Integrator>& c) {
  const int cells = cells_for<S>(c.per_edge, c.particles);
  std::array<int, S::dimension> count;
  count.fill(cells + 4);
  auto body = block<Shape, Law, S>(cells, c.per_edge, state.range(0) != 0, c.law);
  if (c.damaging)
    for (std::size_t p = 0; p < body.size(); ++p) body.v(0)[p] = .5 * body.x(1)[p], body.history(0)[p] = .3;
  using SolverT = Solver<Shape, Law, Integrator, S>;
  std::unique_ptr<SolverT> solver;
  int left = 0;
  for (auto _ : state) {
    if (left-- == 0) {
      state.PauseTiming();
      solver = std::make_unique<SolverT>(Grid<S>(Vector<S>::Zero(), 1, count), body);
      solver->integrator = c.integrator;
      for (int k = 0; k < (c.damaging ? 40 : 3); ++k) solver->step();
      left = c.steps_between - 1;
      state.ResumeTiming();
    }
    solver->step();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(body.size()));
  state.counters["bytes"] = double(body.bytes_per_particle);
}

template <int D>
void scalar_step(benchmark::State& state) {
  using S = std::conditional_t<D == 2, PlaneStrain<>, Spatial<>>;
  const int cells = cells_for<S>(2);
  const Hypoelastic law;
  const auto body = block<Ugimp, Hypoelastic, S>(cells, 2, state.range(0) != 0, law);
  baseline::ScalarUgimp<D> solver;
  solver.cells = cells + 4, solver.half = .25;
  solver.lambda = lame_modulus(law.young, law.poisson), solver.mu = shear_modulus(law.young, law.poisson);
  solver.grid.resize(std::size_t(std::pow(cells + 5, D) + .5));
  for (std::size_t p = 0; p < body.size(); ++p) {
    typename baseline::ScalarUgimp<D>::Vector x, v;
    for (int d = 0; d < D; ++d) x[std::size_t(d)] = body.x(d)[p], v[std::size_t(d)] = body.v(d)[p];
    solver.x.push_back(x), solver.v.push_back(v), solver.stress.push_back({});
    solver.mass.push_back(body.mass()[p]), solver.volume.push_back(body.volume()[p]);
  }
  const double dt = .1 / std::sqrt(law.young / law.density);
  for (auto _ : state) solver.step(dt);
  state.SetItemsProcessed(state.iterations() * std::int64_t(body.size()));
  state.counters["bytes"] = (D + D * D + 2 + D) * 8;
}

/// Prints as usual, and keeps the rates for the table.
class Reporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.aggregate_name != "median" && !(run.run_type == Run::RT_Iteration && run.repetitions == 1)) continue;
      if (run.counters.find("items_per_second") == run.counters.end()) continue;
      const std::string name = run.run_name.function_name;
      if (rate_.find(name) == rate_.end()) order_.push_back(name);
      rate_[name][run.run_name.args == "jittered:1"] = run.counters.at("items_per_second") / 1e6;
      bytes_[name] = run.counters.at("bytes");
    }
  }
  void print_table() const {
    const auto base = [&](const std::string& name, bool jittered) {
      const auto found =
          rate_.find(name.find("3-D") != std::string::npos ? "plain scalar loop, 3-D" : "plain scalar loop");
      return found == rate_.end() ? 0. : found->second[std::size_t(jittered)];
    };
    std::printf(
        "\n| step | bytes a particle | million particle-steps/s, regular | jittered | ratio, regular | jittered |\n"
        "|---|---|---|---|---|---|\n");
    for (const std::string& name : order_) {
      const auto& rate = rate_.at(name);
      std::printf("| %s | %.0f | %.1f | %.1f | %.2f | %.2f |\n", name.c_str(), bytes_.at(name), rate[0], rate[1],
                  rate[0] / base(name, false), rate[1] / base(name, false));
    }
  }

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::array<double, 2>> rate_;
  std::map<std::string, double> bytes_;
};

template <class Shape, class Law, class Integrator, class S = PlaneStrain<>>
void add(const std::string& name, const Case<Law, Integrator>& c = {}) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) { step<Shape, Integrator, S>(s, c); })
      ->ArgName("jittered")
      ->Arg(0)
      ->Arg(1);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RegisterBenchmark("plain scalar loop", scalar_step<2>)->ArgName("jittered")->Arg(0)->Arg(1);
  benchmark::RegisterBenchmark("plain scalar loop, 3-D", scalar_step<3>)->ArgName("jittered")->Arg(0)->Arg(1);
  add<Ugimp, Hypoelastic, Usl>("uGIMP");
  for (const int n : {10000, 1000000, 4000000})
    add<Ugimp, Hypoelastic, Usl>("uGIMP, " + std::to_string(n) + " particles", {.particles = n});
  add<Ugimp, Hypoelastic, Usl, PlaneStrain<float>>("uGIMP, float");
  add<Ugimp, Hypoelastic, Musl>("uGIMP, MUSL");
  add<Ugimp, Hypoelastic, Fmpm>("uGIMP, FMPM(2)");
  add<Ugimp, Hypoelastic, Fmpm>("uGIMP, FMPM(4)", {.integrator = {.order = 4}});
  add<QuadraticBspline, Hypoelastic, Usl>("quadratic B-spline");
  add<CubicBspline, Hypoelastic, Usl>("cubic B-spline");
  add<Linear, Hypoelastic, Usl>("linear");
  add<Cpgimp, Hypoelastic, Usl>("cpGIMP");
  add<Cpdi, Hypoelastic, Usl>("CPDI");
  add<CpdiQuad, Hypoelastic, Usl>("CPDI2");
  add<CpdiQuad, JohnsonHolmquist2, Usl>("CPDI2, JH-2, damaging", {.damaging = true});
  add<Ugimp, JonesWilkinsLee, Usl>("uGIMP, JWL gas, 4 an edge",
                                   {.per_edge = 4, .law = petn_1260(), .steps_between = 10});
  add<Ugimp, Hypoelastic, Usl, Spatial<>>("uGIMP, 3-D");
  Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_table();
}
