// SPDX-License-Identifier: MIT
#pragma once
#include <problems/manufactured.hpp>

namespace mpm::atlas {

/// Of fills and of what else a method is put to, so that its solver is compiled once; some of it asks where particles
/// came from.
using Law = problems::WithOrigin<Hypoelastic>;

}  // namespace mpm::atlas
