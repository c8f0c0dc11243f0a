#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Build a program and run it; all arguments behind the command go to it.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

if [[ ${1-} == --help ]]; then
  cat <<'END'
./run.sh [blast] ...  blast a hole in pre-stressed rock (./run.sh blast --help)
./run.sh chart ...    chart speed against accuracy of every method (./run.sh chart --help)
./run.sh tune ...     name the cheapest method that keeps an error, and run it (./run.sh tune --help)
END
  exit
fi
target=blasting folder=examples/blasting
case ${1-} in
  blast) shift ;;
  chart | tune) target=accuracy_cost folder=benchmarks/accuracy_cost ;;
esac

"$root/cmake/setup-packages.sh" g++ cmake ninja-build libeigen3-dev libboost-dev libboost-program-options-dev \
  libhdf5-dev gnuplot-nox
(cd "$root" && cmake --preset release && cmake --build --preset release --target "$target")
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}  # many short parallel regions: spinning threads get in the way
exec "$root/build/release/$folder/$target" "$@"
