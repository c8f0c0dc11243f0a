// SPDX-License-Identifier: MIT
#include "shape_sweep.hpp"

// Every shipped shape; a new one costs one line.
MPM_SWEEP_SHAPE(Linear, mpm::Linear, Gradient::of_weight, Uniaxial, PlaneStrain, Axisymmetric, Radial, Spatial);
MPM_SWEEP_SHAPE(Ugimp, mpm::Ugimp, Gradient::of_weight, Uniaxial, PlaneStrain, Axisymmetric, Radial, Spatial);
MPM_SWEEP_SHAPE(Cpgimp, mpm::Cpgimp, Gradient::of_weight, Uniaxial, PlaneStrain, Axisymmetric, Radial, Spatial);
MPM_SWEEP_SHAPE(Cpdi, mpm::Cpdi, Gradient::of_domain, Uniaxial, PlaneStrain, Axisymmetric, Radial);
MPM_SWEEP_SHAPE(CpdiQuad, mpm::CpdiQuad, Gradient::of_domain, PlaneStrain);
MPM_SWEEP_SHAPE(QuadraticBspline, mpm::QuadraticBspline, Gradient::of_weight, Uniaxial, PlaneStrain, Axisymmetric,
                Radial, Spatial);
MPM_SWEEP_SHAPE(CubicBspline, mpm::CubicBspline, Gradient::of_weight, Uniaxial, PlaneStrain, Axisymmetric, Radial,
                Spatial);
