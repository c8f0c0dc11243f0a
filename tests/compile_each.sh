#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# compile_each.sh COMPILER FLAGS... -- FILES...: compile each alone, without making code of it, and name those that do
# not. A header is included twice.
set -euo pipefail
command=()
while [[ $1 != -- ]]; do
  command+=("$1")
  shift
done
shift
(($#)) || { echo "FAILED: no file to compile"; exit 1; }

compile() {
  local file=$1 times=1 diagnostics
  shift
  [[ $file != *.hpp ]] || times=2
  diagnostics=$(for ((i = 0; i < times; ++i)); do echo "#include \"$file\""; done | "$@" -fsyntax-only -x c++ - 2>&1) && return
  printf 'FAILED: %s does not compile alone\n%s\n' "$file" "$diagnostics"
  return 1
}
export -f compile
printf '%s\n' "$@" | xargs -P 2 -I {} bash -c 'compile "$@"' _ {} "${command[@]}"
echo "$# files compile alone"
