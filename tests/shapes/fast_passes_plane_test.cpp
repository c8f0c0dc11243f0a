// SPDX-License-Identifier: MIT
#include "fast_passes.hpp"

namespace mpm {
namespace {

/// Domains with corners that are not known to be quadrilaterals take the plain passes by way of them.
struct OwnCorners : CpdiQuad {};

using Plane = ::testing::Types<
    //
    Combination<Linear, Hypoelastic, PlaneStrain<>>, Combination<Ugimp, Hypoelastic, PlaneStrain<>>,
    Combination<Cpgimp, Hypoelastic, PlaneStrain<>>, Combination<QuadraticBspline, Hypoelastic, PlaneStrain<>>,
    Combination<CubicBspline, Hypoelastic, PlaneStrain<>>, Combination<Cpdi, Hypoelastic, PlaneStrain<>>,
    Combination<CpdiQuad, Hypoelastic, PlaneStrain<>>, Combination<Linear, Hypoelastic, PlaneStrain<float>>,
    Combination<Ugimp, Hypoelastic, PlaneStrain<float>>, Combination<Cpgimp, Hypoelastic, PlaneStrain<float>>,
    Combination<QuadraticBspline, Hypoelastic, PlaneStrain<float>>,
    Combination<CubicBspline, Hypoelastic, PlaneStrain<float>>, Combination<Cpdi, Hypoelastic, PlaneStrain<float>>,
    Combination<CpdiQuad, Hypoelastic, PlaneStrain<float>>, Combination<Ugimp, Hypoelastic, Axisymmetric<>>,
    Combination<OwnCorners, Hypoelastic, PlaneStrain<>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Plane, FastPasses, Plane);

}  // namespace
}  // namespace mpm
