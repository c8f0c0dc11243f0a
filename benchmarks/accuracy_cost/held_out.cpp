// SPDX-License-Identifier: MIT
#include "held_out.hpp"
#include <algorithm>
#include <cstdio>

namespace accuracy_cost {
namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

std::vector<Trial> try_out(const Problem& problem, const Table& chart, const Table& own, std::size_t variant,
                           const Measure& measure) {
  std::vector<Trial> trials;
  for (const double budget : {.1, .05, .02, .01, .005, .002}) {
    const auto best = choose(own, budget, 1, problem.step);
    if (!best) continue;
    const auto made = attempts(chart, budget, problem.step, [&](const Choice& choice) {
      return measure(*std::ranges::find(problem.configurations, choice.method, &Configuration::method), choice.cells,
                     variant);
    });
    if (made.empty()) continue;
    const auto& [choice, run] = made.back();
    trials.push_back({problem.name + ": " + problem.variants.at(variant), budget, choice, made.size(), run.error,
                      run.cost, std::min(best->cost, run.error <= budget ? run.cost : best->cost)});
  }
  return trials;
}

std::string report(const std::vector<Trial>& trials) {
  std::string table =
      "| held out | budget | named | cells | runs | true error | kept | cost over the best |\n"
      "|---|---|---|---|---|---|---|---|\n";
  std::vector<double> ratios;
  long kept = 0, at_once = 0;
  for (const Trial& t : trials) {
    table += "| " + t.variant + formatted(" | %.3g %% | ", 100 * t.budget) + name(t.choice.method) +
             formatted(" | %d | %zu | %.3g %% | %s | %.2f |\n", t.choice.cells, t.runs, 100 * t.error,
                       t.kept() ? "yes" : "no", t.cost_ratio());
    kept += t.kept(), at_once += t.kept() && t.runs == 1;
    if (t.kept()) ratios.push_back(t.cost_ratio());
  }
  std::ranges::sort(ratios);
  if (ratios.empty()) return table + "\nno budget was kept\n";
  const long cheap = std::ranges::count_if(ratios, [](double ratio) { return ratio <= 1.5; });
  return table +
         formatted(
             "\n%ld of %zu budgets kept, %ld by the first run; of the kept %ld at no more than 1.5 times the best cost "
             "(median %.2f, largest %.2f)\n",
             kept, trials.size(), at_once, cheap, ratios[ratios.size() / 2], ratios.back());
}

}  // namespace accuracy_cost
