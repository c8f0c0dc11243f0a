// SPDX-License-Identifier: MIT
#include "scene.hpp"
#include <algorithm>
#include <numbers>
#include <numeric>

// FMPM, and FLIP with the same series on its increment, against an exact standing wave, against the modes that bound
// their step, and by way of corners.
namespace mpm::integrator_laws {
namespace {

using S = Uniaxial<>;

/// Relative L2 error in the displacement of a small standing wave in the unit bar between walls, over one period.
template <class Shape, class IntegratorType>
double wave_error(int cells, const IntegratorType& integrator, int particles = 2) {
  const double h = 1. / cells, k = std::numbers::pi, A = 1e-6, period = 2;
  Body<Shape, Hypoelastic, S> bar{"bar", {}, {1, 1, 0}};
  fill(bar, Vector<S>{0.0}, Vector<S>{1.0}, h / particles);
  for (std::size_t p = 0; p < bar.size(); ++p) bar.v(0)[p] = A * k * std::sin(k * bar.x(0)[p]);
  Solver<Shape, Hypoelastic, IntegratorType, S> solver{Grid<S>{Vector<S>{0.0}, h, {cells}}, std::move(bar)};
  solver.integrator = integrator;
  for (int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};
  double error = 0, norm = 0;
  while (solver.time < period) {
    solver.step(std::min(0.2 * h, period - solver.time));
    for (std::size_t p = 0; p < solver.body().size(); ++p) {  // in one dimension they keep their order
      const double X = h * (double(p) + 0.5) / particles, u = A * std::sin(k * X) * std::sin(k * solver.time);
      error += std::pow(solver.body().x(0)[p] - X - u, 2), norm += u * u;
    }
  }
  return std::sqrt(error / norm);
}

template <class Shape>
void expect_order_two(const Fmpm& fmpm, int particles, double error_at_16, double times_better_than_flip) {
  const double coarse = wave_error<Shape>(16, fmpm, particles), fine = wave_error<Shape>(32, fmpm, particles);
  const double flip = wave_error<Shape>(32, Usl{}, particles);
  EXPECT_NEAR(coarse, error_at_16, 0.15 * error_at_16);
  EXPECT_GT(coarse / fine, 3);
  EXPECT_LT(coarse / fine, 9);
  EXPECT_GT(flip / fine, times_better_than_flip);
}
TEST(Fmpm, CutsTheErrorOfAWave) {
  expect_order_two<Cpgimp>({.order = 2}, 2, 2.8e-3, 8);
  expect_order_two<Cpgimp>({.order = 4}, 2, 1.0e-3, 15);
  expect_order_two<Cpdi>({.order = 4}, 2, 1.0e-3, 15);
  expect_order_two<QuadraticBspline>({.order = 4, .strain_share = 1}, 2, 1.4e-3, 20);
  expect_order_two<CubicBspline>({.order = 4, .strain_share = 1}, 4, 6e-4, 60);
}

/// Which velocity strains decides the sign of the dispersion: v+ makes the wave slow, v(k) fast.
TEST(Fmpm, TheMeanVelocityCancelsTheDispersion) {
  const double slow = wave_error<Cpdi>(32, Fmpm{.order = 4, .strain_share = 0});
  const double mean = wave_error<Cpdi>(32, Fmpm{.order = 4, .strain_share = 0.5});
  const double fast = wave_error<Cpdi>(32, Fmpm{.order = 4, .strain_share = 1});
  EXPECT_NEAR(slow, 1.56e-3, 3e-4);
  EXPECT_NEAR(fast, 2.04e-3, 4e-4);
  EXPECT_LT(mean, 4e-4);
}

/// One term is PIC, and the same wave is lost; used every so many steps it dissipates that much less.
TEST(Fmpm, OneTermIsPic) {
  const auto pic = wave_error<Cpgimp>(16, Fmpm{.order = 1, .strain_share = 0});
  const auto also = wave_error<Cpgimp>(16, Fmpm{.order = 1, .strain_share = 1});
  EXPECT_EQ(pic, also);
  EXPECT_GT(pic, 0.1);
  const auto seldom = wave_error<Cpgimp>(16, Fmpm{.order = 1, .interval = 10});
  EXPECT_LT(seldom, 0.4 * pic);
  EXPECT_GT(seldom, 1.5 * wave_error<Cpgimp>(16, Usl{}));
}

TEST(Fmpm, RefusesWhatMeansNothing) {
  for (const Fmpm& fmpm : {Fmpm{.order = 0}, Fmpm{.interval = 0}, Fmpm{.strain_share = 1.1}})
    EXPECT_THROW(wave_error<Linear>(4, fmpm), Error);
}

/// On the increment the series takes away what smoothed accelerations cost FLIP; of the dispersion of v+, which
/// strains, it takes nothing, unless a share of v(k) strains.
TEST(FullMassFlip, LosesWhatFlipSmooths) {
  for (const auto& [order, error_at_16] : {std::pair{1, 1.92e-2}, {2, 7.5e-3}, {4, 7.4e-3}}) {
    const double coarse = wave_error<Cpdi>(16, FullMassFlip{.order = order}),
                 fine = wave_error<Cpdi>(32, FullMassFlip{.order = order});
    EXPECT_NEAR(coarse, error_at_16, 0.1 * error_at_16) << order;
    EXPECT_NEAR(coarse / fine, 4, 0.4) << order;
  }
  const FullMassFlip half{.order = 4, .strain_share = 0.5}, whole{.order = 4, .strain_share = 1};
  EXPECT_NEAR(wave_error<Cpdi>(16, half), 9.7e-4, 1.5e-4);
  EXPECT_NEAR(wave_error<CubicBspline>(16, whole, 4), 2.4e-4, 4e-5);
  EXPECT_EQ(wave_error<Cpdi>(16, FullMassFlip{1, 1}), wave_error<Cpdi>(16, Usl{}));
  for (const FullMassFlip& flip : {FullMassFlip{.order = 0}, FullMassFlip{.strain_share = -0.1}})
    EXPECT_THROW(wave_error<Linear>(4, flip), Error);
}

/// Largest growth of random velocities in 1500 steps of the certain step times `share`: one particle in the middle of
/// each cell, which sees nothing of the shortest wave.
template <class IntegratorType>
double growth(const IntegratorType& integrator, double share) {
  const int cells = 12;
  const double v = 1e-9;
  Body<Linear, Hypoelastic, S> bar{"bar", {}, {1, 1, 0}};
  fill(bar, Vector<S>{0.0}, Vector<S>{double(cells)}, 1);
  std::mt19937_64 engine{19};
  std::uniform_real_distribution<> speed(-v, v);
  for (std::size_t p = 0; p < bar.size(); ++p) bar.v(0)[p] = speed(engine);
  Solver<Linear, Hypoelastic, IntegratorType, S> solver{Grid<S>{Vector<S>{0.0}, 1, {cells}}, std::move(bar)};
  for (int side : {0, 1}) solver.boundary.face(0, side) = Rollers<S>{};
  solver.integrator = integrator;
  solver.safety = share;
  double largest = 0;
  for (int i = 0; i < 1500 && largest < 1e4 * v; ++i) {
    solver.step();
    for (std::size_t p = 0; p < solver.body().size(); ++p)
      largest = std::max(largest, std::abs(solver.body().stress(p).xx));
  }
  return largest / v;
}
TEST(Fmpm, TheStepIsTheLargestThatIsCertain) {
  for (int order : {1, 2, 4, 8})
    for (double share : {0.0, 0.5, 1.0}) {
      const Fmpm fmpm{.order = order, .strain_share = share};
      EXPECT_LT(growth(fmpm, 1), 20) << order << ' ' << share;
      EXPECT_GT(growth(fmpm, 1.2), 1e4) << order << ' ' << share;
    }
}
TEST(FullMassFlip, TheStepIsTheLargestThatIsCertain) {
  for (int order : {1, 2, 4, 8})
    for (double share : {0.0, 0.5, 1.0}) {
      const FullMassFlip flip{.order = order, .strain_share = share};
      EXPECT_LT(growth(flip, 1), 20) << order << ' ' << share;
      EXPECT_GT(growth(flip, 1.2), 1e4) << order << ' ' << share;
    }
}
/// These particles see the shortest wave by its gradient, so that the whole of Irons' step would do; its share is what
/// is certain where they do not.
TEST(Apic, TheStepIsCertain) {
  EXPECT_LT(growth(Apic{}, 1), 2);
  EXPECT_LT(growth(Apic{}, 0.98 / Apic{}.step_factor()), 2);
  EXPECT_GT(growth(Apic{}, 1.06 / Apic{}.step_factor()), 1e4);
}

/// Quadrilaterals talk to the grid by way of their corners: squares at rest must do as parallelograms do without.
template <class IntegratorType>
void expect_the_same_by_way_of_corners(const IntegratorType& integrator) {
  const auto velocities = [&](auto shape) {
    auto solver = block<decltype(shape), IntegratorType, PlaneStrain<>>(9);
    solver.integrator = integrator;
    auto& body = solver.body();
    for (std::size_t p = 0; p < body.size(); ++p)
      body.v(0)[p] = 1e-3 * std::sin(40 * body.x(1)[p]), body.v(1)[p] = 1e-3 * std::cos(60 * body.x(0)[p]);
    solver.step(1e-6);
    std::vector<std::size_t> by_place(body.size());  // the two are not kept in one order
    std::iota(by_place.begin(), by_place.end(), std::size_t(0));
    std::sort(by_place.begin(), by_place.end(), [&](std::size_t a, std::size_t b) {
      const double apart = body.x(1)[a] - body.x(1)[b];
      return std::abs(apart) > 1e-3 ? apart < 0 : body.x(0)[a] < body.x(0)[b];
    });
    std::vector<double> v;
    for (std::size_t p : by_place) v.insert(v.end(), {body.v(0)[p], body.v(1)[p], body.stress(p).xy});
    return v;
  };
  const auto corners = velocities(CpdiQuad{}), plain = velocities(Cpdi{});
  ASSERT_EQ(corners.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(corners[i], plain[i], i % 3 == 2 ? 1e-9 : 1e-15);
  EXPECT_GT(*std::max_element(plain.begin(), plain.end()), 5e-4);
}
TEST(Fmpm, ByWayOfCornersIsTheSame) {
  expect_the_same_by_way_of_corners(Fmpm{.order = 4});
}
TEST(FullMassFlip, ByWayOfCornersIsTheSame) {
  expect_the_same_by_way_of_corners(FullMassFlip{.order = 4, .strain_share = 0.5});
}

}  // namespace
}  // namespace mpm::integrator_laws
