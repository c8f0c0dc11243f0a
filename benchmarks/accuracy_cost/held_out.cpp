// SPDX-License-Identifier: MIT
#include "held_out.hpp"
#include <algorithm>
#include <cstdio>

namespace accuracy_cost {
namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

std::vector<Trial> try_out(const Problem& problem, const Table& chart, const Table& own, std::size_t variant,
                           const Measure& measure) {
  std::vector<Trial> trials;
  for (const double budget : {.1, .05, .02, .01, .005, .002}) {
    const auto choice = choose(chart, budget, margin(chart), problem.step);
    const auto best = choose(own, budget, 1, problem.step);
    if (!choice || !best) continue;
    const auto configuration = std::ranges::find(problem.configurations, choice->method, &Configuration::method);
    const Row run = measure(*configuration, choice->cells, variant);
    trials.push_back({problem.name + ": " + problem.variants.at(variant), budget, *choice, run.error, run.cost,
                      std::min(best->cost, run.error <= budget ? run.cost : best->cost)});
  }
  return trials;
}

std::string report(const std::vector<Trial>& trials) {
  std::string table =
      "| held out | budget | named | cells | true error | kept | cost over the best |\n|---|---|---|---|---|---|---|\n";
  std::vector<double> ratios;
  long kept = 0;
  for (const Trial& t : trials) {
    table += "| " + t.variant + formatted(" | %.3g %% | ", 100 * t.budget) + name(t.choice.method) +
             formatted(" | %d | %.3g %% | %s | %.2f |\n", t.choice.cells, 100 * t.error, t.kept() ? "yes" : "no",
                       t.cost_ratio());
    kept += t.kept();
    if (t.kept()) ratios.push_back(t.cost_ratio());
  }
  std::ranges::sort(ratios);
  if (ratios.empty()) return table + "\nno budget was kept\n";
  const long cheap = std::ranges::count_if(ratios, [](double ratio) { return ratio <= 1.5; });
  return table + formatted(
                     "\n%ld of %zu budgets kept; of these %ld at no more than 1.5 times the best cost "
                     "(median %.2f, largest %.2f)\n",
                     kept, trials.size(), cheap, ratios[ratios.size() / 2], ratios.back());
}

}  // namespace accuracy_cost
