#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check.sh CASE.cpp COMPILER FLAGS...: CASE.cpp compiles as it stands, and with -DMPM_FAULT it does not: the diagnostics
# then match every extended regular expression of its comments "// expect: REGEX".
set -euo pipefail
case=$1
shift

"$@" -fsyntax-only "$case" || { echo "FAILED: the sound twin does not compile"; exit 1; }

if diagnostics=$("$@" -DMPM_FAULT -fsyntax-only "$case" 2>&1); then
  echo "FAILED: the fault compiles"
  exit 1
fi

expected=$(sed -n 's|^// expect: ||p' "$case")
[[ $expected ]] || { echo "FAILED: the case expects no message"; exit 1; }
status=0
while read -r regex; do
  grep -Eq -- "$regex" <<<"$diagnostics" || { echo "FAILED: no diagnostic matches: $regex"; status=1; }
done <<<"$expected"
((status == 0)) || echo "$diagnostics"
exit $status
