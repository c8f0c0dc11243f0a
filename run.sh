#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Build a program and run it; all arguments behind the command go to it.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

if [[ ${1-} == --help ]]; then
  cat <<'END'
./run.sh [blast] ...  blast a hole in pre-stressed rock (./run.sh blast --help)
./run.sh paper ...    make the paper's figures and statements again, a report to open in a browser (./run.sh paper --help)
./run.sh chart ...    chart speed against accuracy of every method (./run.sh chart --help)
./run.sh tune ...     name the cheapest method that keeps an error, and run it (./run.sh tune --help)
./run.sh atlas ...    where each method stands and where it falls: pictures and a table (./run.sh atlas --help)
./run.sh bench ...    time steps and passes of every method, table at the end, bench.json (--quick, Google Benchmark's options)
END
  exit
fi
target=blasting folder=examples/blasting packages=() options=()
case ${1-} in
  blast) shift ;;
  paper)
    shift
    target=paper folder=examples/paper
    ;;
  chart | tune) target=accuracy_cost folder=benchmarks/accuracy_cost ;;
  atlas)
    shift
    target=stability_atlas folder=benchmarks/stability_atlas
    ;;
  bench)
    shift
    target=kernels folder=benchmarks packages=(libbenchmark-dev) options=(-DMPM_BUILD_BENCHMARKS=ON)
    if [[ ${1-} == --quick ]]; then
      shift
      set -- --benchmark_min_time=0.1 "$@"
    fi
    set -- --benchmark_out=bench.json --benchmark_out_format=json "$@"
    export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
    ;;
esac

"$root/cmake/setup-packages.sh" g++ cmake ninja-build libeigen3-dev libboost-dev libboost-program-options-dev \
  libhdf5-dev gnuplot-nox "${packages[@]}"
(cd "$root" && cmake --preset release "${options[@]}" && cmake --build --preset release --target "$target")
export GOMP_SPINCOUNT=${GOMP_SPINCOUNT:-3000}  # many short parallel regions: threads wait some 10 us before they sleep
exec "$root/build/release/$folder/$target" "$@"
