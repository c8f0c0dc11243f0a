// SPDX-License-Identifier: MIT
#include <accuracy_cost/chart.hpp>
#include <accuracy_cost/held_out.hpp>
#include <accuracy_cost/methods.hpp>
#include <accuracy_cost/tune.hpp>
#include <problems/axial_bar.hpp>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include "rows.hpp"

namespace accuracy_cost {
namespace {

/// Errors C / n^order and costs c n^2 at sizes of 10, 20, 40.
void add_line(Table& table, const std::string& shape, double C, double order, double c) {
  for (const int n : {10, 20, 40}) table.push_back(row(shape, n, C / std::pow(n, order), c * n * n));
}

TEST(Tune, NamesTheCheapestBetweenTheSizesOfTheTable) {
  Table table;
  add_line(table, "Ugimp", 10, 2, 1);
  add_line(table, "Cpdi", 4, 2, 2);
  const auto loose = choose(table, .1, 1, 1);  // Ugimp is there at its coarsest size, for 100; Cpdi would cost 200
  EXPECT_EQ(loose->method.shape, "Ugimp");
  EXPECT_EQ(loose->cells, 10);
  const auto tight = choose(table, .01, 1, 1);  // Ugimp needs 31.6 and costs 1024, Cpdi 20 and 800
  EXPECT_EQ(tight->method.shape, "Cpdi");
  EXPECT_EQ(tight->cells, 20);
  EXPECT_NEAR(tight->cost, 800, 1e-9);
  const auto between = choose(table, .005, 1, 1);
  EXPECT_EQ(between->cells, 29);
  EXPECT_NEAR(between->error, 4. / (29 * 29), 1e-9);
  EXPECT_NEAR(between->cost, 2. * 29 * 29, 1e-9);
  EXPECT_EQ(choose(table, .005, 1, 4)->cells, 32);
  EXPECT_EQ(choose(table, .005, 1.5, 1)->cells, 35);
  EXPECT_FALSE(choose(table, 1e-4, 1, 1));
}

TEST(Tune, ADipThatFinerSizesDoNotConfirmIsLuck) {
  const Table table{row("Ugimp", 10, .1, 1), row("Ugimp", 20, .001, 4), row("Ugimp", 40, .02, 16),
                    row("Cpdi", 10, .1, 10), row("Cpdi", 20, .03, 40),  row("Cpdi", 40, .009, 160)};
  EXPECT_EQ(choose(table, .01, 1, 1)->method.shape, "Cpdi");
}

TEST(Tune, AMethodThatFailsAtAFinerSizeIsNotTrusted) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Table table{row("Linear", 10, .01, 1), row("Linear", 20, nan, nan), row("Cpdi", 10, .01, 10)};
  EXPECT_EQ(choose(table, .02, 1, 1)->method.shape, "Cpdi");
}

TEST(Tune, TheMarginIsHowFarErrorsStandAbovePowerLaws) {
  Table table;
  add_line(table, "Ugimp", 10, 2, 1);
  EXPECT_NEAR(margin(table), 1, 1e-12);
  table[1].error *= 1.3;
  EXPECT_NEAR(margin(table), 1.3, 1e-12);
  table[1].error /= 2;  // better than expected needs no margin
  EXPECT_EQ(margin(table), 1);
}

TEST(Tune, NamesAgainWhatTheRunRefutes) {
  Table table;
  add_line(table, "Ugimp", 10, 2, 1);
  std::vector<int> cells;
  const auto true_error_over_expected = [&](double ratio) {
    cells.clear();
    return attempts(table, .02, 1, [&](const Choice& choice) {
      cells.push_back(choice.cells);
      return row("Ugimp", choice.cells, ratio * choice.error, choice.cost);
    });
  };
  EXPECT_EQ(true_error_over_expected(.9).size(), 1u);
  EXPECT_EQ(cells, (std::vector{23}));  // 10 / 23^2 = .0189
  EXPECT_LE(true_error_over_expected(1.3).back().run.error, .02);
  EXPECT_EQ(cells, (std::vector{23, 26}));
  EXPECT_GT(true_error_over_expected(4).back().run.error, .02);  // 40 cells are all there is
  EXPECT_EQ(cells, (std::vector{23}));
  EXPECT_EQ(true_error_over_expected(std::numeric_limits<double>::quiet_NaN()).size(), 2u);  // 23, 33, 47
  EXPECT_EQ(cells, (std::vector{23, 33}));
  EXPECT_TRUE(attempts(table, 1e-4, 1, [](const Choice&) { return Row{}; }).empty());
}

/// The swinging bar, by some methods, for a time that the chart holds and two that it does not.
Problem swinging_bar() {
  using Options = mpm::problems::AxialBarOptions;
  const auto run = []<class Shape, class Integrator, class Scalar>(const Options& options, Integrator integrator) {
    return mpm::problems::axial_bar<Shape, Integrator, Scalar>(options, integrator);
  };
  Methods methods(std::vector<Options>{{.periods = 2.125}, {.periods = 1.875}, {.periods = 2.375}}, {{2, .8}}, run);
  methods.add<mpm::Ugimp, double>("USF", "FLIP", mpm::Usf{}).add<mpm::Ugimp, double>("MUSL", "FLIP", mpm::Musl{});
  methods.add<mpm::Cpdi, double>("USL", "FLIP", mpm::Usl{}).add<mpm::Cpdi, double>("USL", "FMPM(2)", mpm::Fmpm{});
  return {.name = "bar",
          .variants = {"2 1/8", "1 7/8", "2 3/8"},
          .quick = {5, 10, 20, 40},
          .configurations = methods.take()};
}

/// Costs that do not hang on the machine: particle-steps.
Row with_work_as_cost(Row row) {
  row.cost = double(row.particles) * double(row.steps);
  return row;
}
Table worked(const Problem& problem, std::size_t variant) {
  Table table = measure_all(problem, variant, Extent::quick);
  for (Row& row : table) row = with_work_as_cost(row);
  return table;
}

TEST(Tune, KeepsNineBudgetsOfTenWithParametersItHasNotSeen) {
  const Problem problem = swinging_bar();
  const Table chart = worked(problem, 0);
  std::vector<Trial> trials;
  for (const std::size_t variant : {1, 2}) {
    const auto tried = try_out(problem, chart, worked(problem, variant), variant, [&](const auto& c, int n, auto v) {
      return with_work_as_cost(measure(problem, c, n, v));
    });
    trials.insert(trials.end(), tried.begin(), tried.end());
  }
  const double enough = .9 * double(trials.size());
  ASSERT_GE(trials.size(), 10u);
  EXPECT_GE(double(std::ranges::count_if(trials, &Trial::kept)), enough) << report(trials);
  EXPECT_GE(double(std::ranges::count_if(trials, [](const Trial& t) { return t.cost_ratio() <= 1.5; })), enough)
      << report(trials);
}

TEST(Chart, ErrorsRepeatToTheBitAndFailuresAreRows) {
  const Problem problem = swinging_bar();
  const Row a = measure(problem, problem.configurations[0], 10, 0),
            b = measure(problem, problem.configurations[0], 10, 0);
  EXPECT_EQ(a.error, b.error);
  EXPECT_GT(a.cost, 0);
  int calls = 0;
  const Configuration failing{a.method, true, [&](int, std::size_t) -> mpm::problems::Outcome {
                                ++calls;
                                throw mpm::Error("falls");
                              }};
  EXPECT_TRUE(std::isnan(measure(problem, failing, 10, 0).error));
  EXPECT_EQ(calls, 1);
  const Configuration fickle{a.method, true,
                             [&](int, std::size_t) { return mpm::problems::Outcome{.error = double(++calls)}; }};
  EXPECT_THROW(measure(problem, fickle, 10, 0), std::logic_error);
}

}  // namespace
}  // namespace accuracy_cost
