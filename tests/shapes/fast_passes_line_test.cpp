// SPDX-License-Identifier: MIT
#include "fast_passes.hpp"

namespace mpm {
namespace {

using Line = ::testing::Types<
    //
    Combination<Linear, Hypoelastic, Uniaxial<>>, Combination<Ugimp, Hypoelastic, Uniaxial<>>,
    Combination<Cpgimp, Hypoelastic, Uniaxial<>>, Combination<QuadraticBspline, Hypoelastic, Uniaxial<>>,
    Combination<CubicBspline, Hypoelastic, Uniaxial<>>, Combination<Cpdi, Hypoelastic, Uniaxial<>>,
    Combination<Linear, Hypoelastic, Uniaxial<float>>, Combination<Ugimp, Hypoelastic, Uniaxial<float>>,
    Combination<Cpgimp, Hypoelastic, Uniaxial<float>>, Combination<QuadraticBspline, Hypoelastic, Uniaxial<float>>,
    Combination<CubicBspline, Hypoelastic, Uniaxial<float>>, Combination<Cpdi, Hypoelastic, Uniaxial<float>>,
    Combination<Ugimp, Hypoelastic, Radial<>>, Combination<Cpdi, Hypoelastic, Radial<float>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Line, FastPasses, Line);

}  // namespace
}  // namespace mpm
