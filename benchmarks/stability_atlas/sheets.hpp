// SPDX-License-Identifier: MIT
#pragma once
#include <vector>
#include "sheet.hpp"

namespace mpm::atlas {

// The sheets of the atlas; `quick` takes coarser ones.
Sheet growing_amplitude(bool quick);
Sheet particles_a_cell(bool quick);
Sheet numerical_fracture(bool quick);
Sheet struck_bar_energy(bool quick);
Sheet checkerboard_decay(bool quick);
Sheet relaxation_stop(bool quick);
Sheet shear_flow(bool quick);
Sheet spin(bool quick);
Sheet turn(bool quick);
Sheet over_stretch(bool quick);
Sheet gas_in_a_box(bool quick);
Sheet locking(bool quick);
Sheet bending(bool quick);

}  // namespace mpm::atlas
