#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Build the blasting program and run it; all arguments go to it (./run.sh --help).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

"$root/cmake/setup-packages.sh" g++ cmake ninja-build libeigen3-dev libboost-dev libboost-program-options-dev \
  libhdf5-dev gnuplot-nox
(cd "$root" && cmake --preset release && cmake --build --preset release --target blasting)
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}  # many short parallel regions: spinning threads get in the way
exec "$root/build/release/examples/blasting/blasting" "$@"
