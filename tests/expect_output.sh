#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# expect_output.sh REGEX COMMAND...: COMMAND succeeds, and what it prints matches the extended regular expression, whose
# dot also matches the end of a line. (CTest's PASS_REGULAR_EXPRESSION would ignore the exit code.)
set -euo pipefail
regex=$1
shift

status=0
output=$("$@" 2>&1) || status=$?
echo "$output"
((status == 0)) || { echo "FAILED: exit code $status"; exit 1; }
[[ $output =~ $regex ]] || { echo "FAILED: the output does not match: $regex"; exit 1; }
