// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/mpm.hpp>

namespace mpm::atlas {

/// Calls f(name, integrator) for every explicit integrator with every transfer: those of a time of the stress update
/// with FLIP, with a little of PIC and with PIC, and those that have a transfer of their own.
template <class F>
void for_each_integrator(const F& f) {
  f("USF", Usf{});
  f("USL", Usl{});
  f("MUSL", Musl{});
  f("FMPM(2)", Fmpm{.order = 2});
  f("FMPM(4)", Fmpm{.order = 4});
  f("full-mass FLIP(2)", FullMassFlip{.order = 2});
  f("APIC", Apic{});
  f("USF FLIP .99", Usf{.flip = .99});
  f("USL FLIP .99", Usl{.flip = .99});
  f("MUSL FLIP .99", Musl{.flip = .99});
  f("USF PIC", Usf{.flip = 0});
  f("USL PIC", Usl{.flip = 0});
  f("MUSL PIC", Musl{.flip = 0});
}

}  // namespace mpm::atlas
