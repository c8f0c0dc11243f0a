// SPDX-License-Identifier: MIT
#include "law_sweep.hpp"
#include <mpm/materials/neo_hookean.hpp>
#include <mpm/materials/presets.hpp>

// Every shipped law; a new one costs one line.
MPM_SWEEP_LAW(Hypoelastic, mpm::granite_elastic());
MPM_SWEEP_LAW(NeoHookean, mpm::NeoHookean{.density = 1000, .young = 1e6, .poisson = .3});
MPM_SWEEP_LAW(JohnsonHolmquist2, mpm::JohnsonHolmquist2(mpm::granite_1200()));
MPM_SWEEP_LAW(JohnsonHolmquist2WithTensileLaw, mpm::granite_paper());
MPM_SWEEP_LAW(JonesWilkinsLee, mpm::petn_1260());
MPM_SWEEP_LAW(PolynomialEos, mpm::air());
