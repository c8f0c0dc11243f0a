// SPDX-License-Identifier: MIT
#include <mpm/analysis/blair_fit.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace {
using namespace mpm::analysis;
constexpr double a = 0.021;
constexpr BlastCavity cavity{.young = 51188.28e6,
                             .poisson = 0.16818,
                             .density = 2660,
                             .radius = a,
                             .load = {.peak = 100e6, .n = 2, .gamma = 1e5}};

// Inverted by Talbot's method with 50 digits: r/a, t (us), rr (Pa), tt (Pa), u (m).
constexpr double talbot[][5] = {
    {1, 20, -1.000000000e+08, 1.054240705e+08, 5.008688939e-05},
    {1, 40, -5.413411329e+07, 7.061824701e+07, 3.251490002e-05},
    {1, 60, -1.648407500e+07, 1.364262968e+07, 6.767195468e-06},
    {1, 80, -3.966003483e+06, 1.184255704e+06, 7.917575965e-07},
    {1, 100, -8.386565698e+05, -3.246282544e+05, -6.181651381e-08},
    {1, 150, -1.271435291e+04, -1.550054543e+05, -6.076759973e-08},
    {2, 20, -3.558383334e+07, 2.248309612e+07, 2.366169743e-05},
    {2, 40, -6.770814548e+06, 2.415369871e+07, 2.034902153e-05},
    {2, 60, -3.235251889e+06, 3.231218852e+06, 3.097747739e-06},
    {2, 80, -1.707902186e+06, -5.945669573e+05, -1.987315363e-07},
    {2, 100, -6.126297203e+05, -5.003018794e+05, -3.001317018e-07},
    {2, 150, -6.863659707e+04, -1.027168117e+05, -7.083121704e-08},
    {5, 20, -1.528767304e+06, -2.754276857e+05, 6.709882382e-08},
    {5, 40, -3.626435003e+06, 7.331638013e+06, 1.607510272e-05},
    {5, 60, 4.687605438e+06, 3.051732276e+06, 4.193715377e-06},
    {5, 80, -2.292222171e+05, -6.152480984e+05, -1.133956207e-06},
    {5, 100, -6.059611609e+05, -5.633237134e+05, -8.786338170e-07},
    {5, 150, -1.002177682e+05, -9.602012561e+04, -1.510028440e-07},
    {10, 20, 0.000000000e+00, 0.000000000e+00, 0.000000000e+00},
    {10, 40, 0.000000000e+00, 0.000000000e+00, 0.000000000e+00},
    {10, 60, -3.915149913e+06, 1.790933679e+06, 1.029508830e-05},
    {10, 80, 5.172038722e+06, 1.812186961e+06, 3.055576296e-06},
    {10, 100, 2.518595277e+05, -3.203571076e+05, -1.480089948e-06},
    {10, 150, -1.767592048e+05, -1.288729376e+05, -3.712801615e-07},
};

struct PeakRow {
  double r, hoop, hoop_time, compression, tension, tension_time;  // in a, MPa and us
};
constexpr PeakRow peak_table[] = {{1, 116.2822, 25.285, -100, 0, 0},
                                  {1.5, 55.96370, 27.099, -51.9991, 0, 0},
                                  {2, 33.96478, 29.231, -36.6953, 0, 0},
                                  {3, 17.33530, 33.929, -24.9857, 2.7976, 46.99},
                                  {5, 7.902115, 43.847, -17.00755, 5.98700, 53.16},
                                  {10, 3.146175, 68.609, -11.00878, 5.91397, 74.75}};

TEST(BlairLoad, PeaksAtNOverGamma) {
  const BlairLoad& load = cavity.load;
  EXPECT_NEAR(load.pressure(20e-6), 100e6, 1e-6);
  EXPECT_LT(load.pressure(19e-6), 100e6);
  EXPECT_LT(load.pressure(21e-6), 100e6);
  EXPECT_EQ(load.pressure(-1e-6), 0);
}

TEST(BlairLoad, TransformIsTheIntegral) {
  const BlairLoad load{.peak = 3, .n = 1.5, .gamma = 2};
  const std::complex<double> m(0.7, 3);
  const double dt = 1e-4;
  std::complex<double> integral = 0;
  for (int i = 1; i < 150000; ++i) integral += dt * load.pressure(i * dt) * std::exp(-m * (i * dt));
  EXPECT_LT(std::abs(load.transform(m) - integral), 1e-7);
}

TEST(BlastCavity, HistoryOfTheReferenceTable) {
  for (const auto& [r, t, rr, tt, u] : talbot) {
    const CavityState s = cavity.at(r * a, t * 1e-6);
    EXPECT_NEAR(s.rr, rr, 2e-8 * std::abs(rr)) << r << " a, " << t << " us";
    EXPECT_NEAR(s.tt, tt, 2e-8 * std::abs(tt)) << r << " a, " << t << " us";
    EXPECT_NEAR(s.u, u, 2e-8 * std::abs(u)) << r << " a, " << t << " us";
  }
}

TEST(BlastCavity, PeaksOfTheReferenceTable) {
  for (const auto& row : peak_table) {
    const CavityPeaks p = cavity.peaks(row.r * a, 200e-6);
    EXPECT_NEAR(p.hoop.value, row.hoop * 1e6, 6e-7 * row.hoop * 1e6) << row.r;
    EXPECT_NEAR(p.hoop.time, row.hoop_time * 1e-6, 0.6e-9) << row.r;
    EXPECT_NEAR(p.compression.value, row.compression * 1e6, 1e-6 * 100e6) << row.r;
    EXPECT_NEAR(p.tension.value, row.tension * 1e6, 60) << row.r;
    if (row.tension > 0) {
      EXPECT_NEAR(p.tension.time, row.tension_time * 1e-6, 6e-9) << row.r;
    }
  }
  EXPECT_NEAR(cavity.peaks(2 * a, 200e-6).compression.time, 17.780e-6, 0.6e-9);
  EXPECT_NEAR(cavity.peaks(5 * a, 200e-6).compression.time, 29.149e-6, 0.6e-9);
  EXPECT_NEAR(cavity.peaks(10 * a, 200e-6).compression.time, 51.675e-6, 0.6e-9);
}

TEST(BlastCavity, WallCarriesTheLoadAtAllTimes) {
  for (double t = 1e-7; t < 1e-3; t *= 1.3) EXPECT_NEAR(cavity.at(a, t).rr, -cavity.load.pressure(t), 0.01) << t;
}

TEST(BlastCavity, RestsUntilTheFrontArrives) {
  const double r = 5 * a, front = cavity.arrival(r);
  EXPECT_NEAR(front, 4 * a / 4544, 1e-3 * front);  // c_p of the rock is 4544 m/s
  const CavityState before = cavity.at(r, 0.9999 * front), after = cavity.at(r, front + 1e-6);
  EXPECT_EQ(before.rr, 0);
  EXPECT_EQ(before.tt, 0);
  EXPECT_EQ(before.u, 0);
  EXPECT_LT(after.rr, -1e5);  // a plane front: tt = lambda/(lambda + 2 mu) rr
  EXPECT_NEAR(after.tt / after.rr, 0.16818 / (1 - 0.16818), 0.1);
}

TEST(BlastCavity, BalancesMomentumAndObeysHooke) {
  const double r = 3 * a, t = 40e-6, dr = 1e-5, dt = 1e-7;
  const CavityState s = cavity.at(r, t), out = cavity.at(r + dr, t), in = cavity.at(r - dr, t);
  const double inertia = cavity.density * (cavity.at(r, t + dt).u - 2 * s.u + cavity.at(r, t - dt).u) / (dt * dt);
  const double force = (out.rr - in.rr) / (2 * dr) + (s.rr - s.tt) / r;
  EXPECT_NEAR(inertia, force, 1e-4 * std::abs(s.rr - s.tt) / r);
  const double strain = (out.u - in.u) / (2 * dr);
  const double longitudinal = cavity.longitudinal_modulus(), lambda = longitudinal - 2 * cavity.shear_modulus();
  EXPECT_NEAR(s.rr, longitudinal * strain + lambda * s.u / r, 1e-5 * std::abs(s.rr));
  EXPECT_NEAR(s.tt, longitudinal * s.u / r + lambda * strain, 1e-5 * std::abs(s.tt));
}

TEST(BlastCavity, HistoryIsTheSequenceOfStates) {
  const double times[] = {10e-6, 40e-6, 90e-6};
  const auto states = cavity.history(2 * a, times);
  ASSERT_EQ(states.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(states[i].tt, cavity.at(2 * a, times[i]).tt);
}

TEST(BlastCavity, RefusesWhatHasNoMeaning) {
  EXPECT_THROW(cavity.at(0.9 * a, 1e-5), std::invalid_argument);
  EXPECT_THROW(cavity.peaks(10 * a, 1e-6), std::invalid_argument);
  BlastCavity incompressible = cavity;
  incompressible.poisson = 0.5;
  EXPECT_THROW(incompressible.at(a, 1e-5), std::invalid_argument);
}
TEST(BlairFit, FindsThePulseThatItIsGiven) {
  for (const double n : {.2, 2., 7.}) {
    const BlairLoad load{.peak = 3e9, .n = n, .gamma = n / 4e-6};
    std::vector<double> time, pressure;
    for (int i = 0; i <= 100; ++i) time.push_back(5e-7 * i), pressure.push_back(load.pressure(time.back()));
    const auto found = fit_blair(time, pressure);
    EXPECT_NEAR(found.peak, 3e9, 1e-3);
    EXPECT_NEAR(found.n, n, 1e-4 * n);
    EXPECT_NEAR(found.gamma, load.gamma, 1e-4 * load.gamma);
  }
  const double zero[] = {0, 0};
  EXPECT_THROW(fit_blair(zero, zero), std::invalid_argument);
  EXPECT_THROW(fit_blair(zero, {}), std::invalid_argument);
}

}  // namespace
