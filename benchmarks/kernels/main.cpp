// SPDX-License-Identifier: MIT
#include "machine.hpp"
#include "scalar_ugimp.hpp"
#include "step.hpp"
#include <cstdio>
#include <map>

// Times whole steps, locating and sorting included, by method, against the plain scalar loop of scalar_ugimp.hpp in the
// same run, then the passes between particles and grid (passes.cpp), each beside its plain form. Ends with the table of
// steps. items_per_second is particle-steps a second; `bytes` what a particle holds; `flops` what its transfers ask
// for.
namespace kernels {

namespace {

template <int D>
void scalar_step(benchmark::State& state) {
  using S = std::conditional_t<D == 2, PlaneStrain<>, Spatial<>>;
  const int cells = cells_for<S>(2, usual_count);
  const Hypoelastic law;
  const auto body = block<Ugimp, Hypoelastic, S>(cells, 2, Layout(state.range(0)), law);
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
  std::array<int, D> count;
  count.fill(cells + 4);
  state.counters["bytes"] = (D + D * D + 2 + D) * 8;
  state.counters["flops"] = transfer_flops(body, Grid<S>(Vector<S>::Zero(), 1, count));
  const double dt = .1 / std::sqrt(law.young / law.density);
  for (auto _ : state) solver.step(dt);
  state.SetItemsProcessed(state.iterations() * std::int64_t(body.size()));
}
void add_scalar_loop(const char* name, void (*f)(benchmark::State&)) {
  benchmark::RegisterBenchmark(name, f)
      ->ArgName("layout")
      ->Arg(std::int64_t(Layout::regular))
      ->Arg(std::int64_t(Layout::jittered))
      ->UseRealTime();
}

/// Prints as usual, and keeps the steps for the table.
class Reporter : public benchmark::ConsoleReporter {
 public:
  Reporter() : ConsoleReporter(OO_Tabular), peak_(peak_flops()), triad_(triad_bytes()) {}

  bool ReportContext(const Context& context) override {
    ConsoleReporter::ReportContext(context);
    std::printf("One core: %.1f GFLOP/s in multiply-adds, %.1f GB/s in a triad\n", peak_ * 1e-9, triad_ * 1e-9);
    return true;
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const std::string& arguments = run.run_name.args;
      const bool step = arguments.starts_with("layout:"), blast = arguments.starts_with("threads:");
      if (!(step || blast) || run.run_type != Run::RT_Iteration) continue;
      const std::string name = run.run_name.function_name + (blast ? ", " + arguments : "");
      if (rows_.find(name) == rows_.end()) order_.push_back(name);
      Row& row = rows_[name];
      double& rate = row.rate[arguments == "layout:1"];
      rate = std::max(rate, double(run.counters.at("items_per_second")));
      row.bytes = run.counters.at("bytes"), row.flops = run.counters.at("flops");
    }
  }
  void print_table() const {
    std::printf(
        "\n| step | B/particle | M particle-steps/s | jittered | ratio | jittered | of the peak | of the triad |\n"
        "|---|---|---|---|---|---|---|---|\n");
    for (const std::string& name : order_) {
      const Row& row = rows_.at(name);
      const auto base =
          rows_.find(name.find("3-D") == std::string::npos ? "plain scalar loop" : "plain scalar loop, 3-D");
      const auto text = [](const char* format, double x) {
        char out[32];
        std::snprintf(out, sizeof out, format, x);
        return std::string(x > 0 ? out : "");
      };
      const auto ratio = [&](int jittered) {
        return base == rows_.end() ? 0. : row.rate[jittered] / base->second.rate[jittered];
      };
      // Read and written once: the least that a step moves.
      const double moved = 2 * row.bytes * row.rate[0] / triad_, done = row.flops * row.rate[0] / peak_;
      std::printf("| %s | %.0f | %s | %s | %s | %s | %s | %s |\n", name.c_str(), row.bytes,
                  text("%.1f", row.rate[0] * 1e-6).c_str(), text("%.1f", row.rate[1] * 1e-6).c_str(),
                  text("%.2f", ratio(0)).c_str(), text("%.2f", ratio(1)).c_str(), text("%.0f %%", 100 * done).c_str(),
                  text("%.0f %%", 100 * moved).c_str());
    }
  }

 private:
  struct Row {
    double rate[2] = {}, bytes = 0, flops = 0;  ///< rate: as laid out, jittered
  };
  double peak_, triad_;
  std::vector<std::string> order_;
  std::map<std::string, Row> rows_;
};

}  // namespace
}  // namespace kernels

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  kernels::Reporter reporter;
  kernels::add_scalar_loop("plain scalar loop", kernels::scalar_step<2>);
  kernels::add_scalar_loop("plain scalar loop, 3-D", kernels::scalar_step<3>);
  kernels::add_ugimp();
  kernels::add_splines();
  kernels::add_domains();
  kernels::add_laws();
  kernels::add_space();
  kernels::add_blast();
  kernels::add_passes();
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_table();
}
