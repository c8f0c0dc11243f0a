// SPDX-License-Identifier: MIT
#include "fast_passes.hpp"

namespace mpm {
namespace {

using Space3D = ::testing::Types<
    //
    Combination<Linear, Hypoelastic, Spatial<>>, Combination<Ugimp, Hypoelastic, Spatial<>>,
    Combination<Cpgimp, Hypoelastic, Spatial<>>, Combination<QuadraticBspline, Hypoelastic, Spatial<>>,
    Combination<CubicBspline, Hypoelastic, Spatial<>>, Combination<Linear, Hypoelastic, Spatial<float>>,
    Combination<Ugimp, Hypoelastic, Spatial<float>>, Combination<Cpgimp, Hypoelastic, Spatial<float>>,
    Combination<QuadraticBspline, Hypoelastic, Spatial<float>>, Combination<CubicBspline, Hypoelastic, Spatial<float>>,
    Combination<Cpgimp, NeoHookean, Spatial<>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Space3D, FastPasses, Space3D);

}  // namespace
}  // namespace mpm
