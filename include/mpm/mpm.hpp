// SPDX-License-Identifier: MIT
#pragma once

// The framework's core. Beside it stand <mpm/analysis/...>: energies, exact solutions, read-outs; <mpm/geometry/...>: a
// block with a hole; <mpm/materials/presets.hpp>; and <mpm/io/...> for drivers that read scenes or write snapshots.
#include <mpm/energy_guard.hpp>
#include <mpm/relax.hpp>
#include <mpm/solver.hpp>

#include <mpm/integrators/apic.hpp>
#include <mpm/integrators/dynamic_relaxation.hpp>
#include <mpm/integrators/explicit.hpp>
#include <mpm/integrators/fmpm.hpp>
#include <mpm/integrators/full_mass_flip.hpp>

#include <mpm/shapes/bspline.hpp>
#include <mpm/shapes/cpdi.hpp>
#include <mpm/shapes/cpdi_quad.hpp>
#include <mpm/shapes/cpgimp.hpp>
#include <mpm/shapes/linear.hpp>
#include <mpm/shapes/mean_dilatation.hpp>
#include <mpm/shapes/ugimp.hpp>

#include <mpm/materials/hypoelastic.hpp>
#include <mpm/materials/johnson_holmquist2.hpp>
#include <mpm/materials/jones_wilkins_lee.hpp>
#include <mpm/materials/neo_hookean.hpp>
#include <mpm/materials/polynomial_eos.hpp>
#include <mpm/materials/rankine_softening.hpp>

#include <mpm/geometry/lattice.hpp>

#include <mpm/spaces/axisymmetric.hpp>
#include <mpm/spaces/plane_strain.hpp>
#include <mpm/spaces/radial.hpp>
#include <mpm/spaces/spatial.hpp>
#include <mpm/spaces/uniaxial.hpp>
