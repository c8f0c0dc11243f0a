// SPDX-License-Identifier: MIT
#include "fast_passes.hpp"

namespace mpm {
namespace {

using Laws = ::testing::Types<
    //
    Combination<Ugimp, NeoHookean, PlaneStrain<>>, Combination<Ugimp, JohnsonHolmquist2, PlaneStrain<>>,
    Combination<Ugimp, JonesWilkinsLee, PlaneStrain<>>, Combination<Ugimp, PolynomialEos, PlaneStrain<>>,
    Combination<Ugimp, NeoHookean, PlaneStrain<float>>, Combination<Ugimp, JohnsonHolmquist2, PlaneStrain<float>>,
    Combination<Ugimp, JonesWilkinsLee, PlaneStrain<float>>, Combination<Ugimp, PolynomialEos, PlaneStrain<float>>,
    Combination<CpdiQuad, WithTensileLaw<JohnsonHolmquist2>, PlaneStrain<>>,
    Combination<CpdiQuad, WithTensileLaw<JohnsonHolmquist2>, PlaneStrain<float>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Laws, FastPasses, Laws);

}  // namespace
}  // namespace mpm
