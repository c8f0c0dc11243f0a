// SPDX-License-Identifier: MIT
#include "programs.hpp"
#include <mpm/io/text.hpp>
#include <mpm/io/units.hpp>
#include <program/output_folder.hpp>
#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include "chart.hpp"
#include "held_out.hpp"
#include "picture.hpp"

namespace accuracy_cost {
namespace {

std::vector<Problem> chosen(const Options& options) {
  if (options.problems.empty()) return all_problems();
  std::vector<Problem> problems;
  for (const auto& name : options.problems) problems.push_back(find_problem(name));
  return problems;
}

/// On one line of a terminal that it writes over.
void show_progress(const Problem& problem, const Method& method, int cells) {
  if (!isatty(STDERR_FILENO)) return;
  std::fprintf(stderr, "\r%s, %s, %d cells\33[K", problem.name.c_str(), name(method).c_str(), cells);
}
void end_progress() {
  if (isatty(STDERR_FILENO)) std::fputs("\r\33[K", stderr);
}

Table measured(const Problem& problem, std::size_t variant, Extent extent) {
  Table rows = measure_all(problem, variant, extent, show_progress);
  end_progress();
  return rows;
}

/// The machine's last chart; the problem's part of a quick one, made on the spot, where there is none.
Table known(const Options& options, const Problem& problem) {
  const auto file = options.output / "chart.csv";
  if (std::filesystem::exists(file)) {
    Table rows = rows_of(read(file), problem.name);
    // An older program may have known other methods.
    std::erase_if(rows, [&](const Row& row) {
      return std::ranges::find(problem.configurations, row.method, &Configuration::method) ==
             problem.configurations.end();
    });
    if (!rows.empty()) return rows;
  }
  std::cerr << "no chart of " << problem.name << " in " << options.output.string() << ": making a quick one\n";
  return measured(problem, 0, Extent::quick);
}

bool tune_one(const Options& options) {
  const Problem problem = find_problem(options.problems.front());
  const Table rows = known(options, problem);
  const auto run = [&](const Choice& choice) {
    std::printf("%s within %g %%: %s, %d cells\nexpected: error %.3g %%, cost %.2g core-seconds\n",
                problem.name.c_str(), 100 * options.error, name(choice.method).c_str(), choice.cells,
                100 * choice.error, choice.cost);
    const auto configuration = std::ranges::find(problem.configurations, choice.method, &Configuration::method);
    const Row row = measure(problem, *configuration, choice.cells, 0);
    std::printf("measured: error %.3g %%, cost %.2g core-seconds: the budget is %s\n", 100 * row.error, row.cost,
                row.error <= options.error ? "kept" : "missed");
    return row;
  };
  const auto made = attempts(rows, options.error, problem.step, run);
  if (made.empty()) {
    const Table best = front(rows);
    throw mpm::io::InputError("--error: no method of the chart keeps that on " + problem.name +
                              (best.empty() ? "" : "; the least is " + mpm::io::number(best.back().error)));
  }
  return made.back().run.error <= options.error;
}

void check(const Options& options) {
  std::vector<Trial> trials;
  for (const Problem& problem : chosen(options)) {
    const Table rows = known(options, problem);
    for (std::size_t v = 1; v < problem.variants.size(); ++v) {
      const auto run = [&](const Configuration& configuration, int cells, std::size_t variant) {
        return measure(problem, configuration, cells, variant);
      };
      const auto tried = try_out(problem, rows, measured(problem, v, Extent::quick), v, run);
      trials.insert(trials.end(), tried.begin(), tried.end());
    }
  }
  std::cout << report(trials);
}

}  // namespace

void chart(const Options& options) {
  program::prepare_output(options.output, options.force);
  Table table;
  std::string fronts;
  for (const Problem& problem : chosen(options)) {
    const Table rows = measured(problem, 0, options.quick ? Extent::quick : Extent::full);
    table.insert(table.end(), rows.begin(), rows.end());
    write(table, options.output / "chart.csv");
    // Scenes are few, and what the ones off the front cost is the point.
    const bool scenes = !problem.configurations.front().method.scene.empty();
    fronts += (fronts.empty() ? "**" : "\n**") + problem.title + "**\n\n" + markdown(scenes ? rows : front(rows));
    mpm::io::replace_file(options.output / "front.md", fronts);
    draw(rows, problem.title, options.output / (problem.name + ".png"));
  }
  std::cout << fronts;
}

bool tune(const Options& options) {
  if (!options.check) return tune_one(options);
  check(options);
  return true;
}

}  // namespace accuracy_cost
