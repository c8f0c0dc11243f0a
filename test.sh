#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Build all tests with warnings as errors and run them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

cmake/setup-packages.sh g++ cmake ninja-build libeigen3-dev libboost-dev libboost-program-options-dev libhdf5-dev \
  gnuplot-nox libgtest-dev libbenchmark-dev python3-vtk9 clang libomp-dev
cmake --preset ci
cmake --build --preset ci
ctest --preset ci "$@"
