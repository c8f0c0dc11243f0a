// SPDX-License-Identifier: MIT
#include "fast_passes.hpp"

namespace mpm {
namespace {

using Line = ::testing::Types<
    //
    Combination<Linear, Hypoelastic, Uniaxial<>>, Combination<Ugimp, Hypoelastic, Uniaxial<>>,
    Combination<Ugimp, Hypoelastic, Radial<>>, Combination<Cpgimp, Hypoelastic, Uniaxial<>>,
    Combination<QuadraticBspline, Hypoelastic, Uniaxial<>>, Combination<CubicBspline, Hypoelastic, Uniaxial<>>,
    Combination<Cpdi, Hypoelastic, Uniaxial<>>, Combination<Cpdi, Hypoelastic, Radial<float>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Line, FastPasses, Line);

}  // namespace
}  // namespace mpm
