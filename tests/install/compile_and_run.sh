#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# compile_and_run.sh PROGRAM COMPILER ARGUMENTS...
set -euo pipefail
program=$1
shift
"$@" -o "$program"
"$program"
