// SPDX-License-Identifier: MIT
#include "fast_passes.hpp"

namespace mpm {
namespace {

using Laws = ::testing::Types<
    //
    Combination<CpdiQuad, WithTensileLaw<JohnsonHolmquist2>, PlaneStrain<>>,
    Combination<Ugimp, NeoHookean, PlaneStrain<>>, Combination<Ugimp, JohnsonHolmquist2, PlaneStrain<>>,
    Combination<Ugimp, JonesWilkinsLee, PlaneStrain<>>, Combination<Ugimp, PolynomialEos, PlaneStrain<>>,
    Combination<Ugimp, PolynomialEos, PlaneStrain<float>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Laws, FastPasses, Laws);

}  // namespace
}  // namespace mpm
