#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check.sh COMPILER FLAGS... -- SOURCES...: compile each source, without making code of it, and name those that fail.
set -euo pipefail
command=()
while [[ $1 != -- ]]; do
  command+=("$1")
  shift
done
shift

compile() {
  local source=$1 diagnostics
  shift
  diagnostics=$("$@" -fsyntax-only "$source" 2>&1) && return
  printf 'FAILED: %s does not compile\n%s\n' "$source" "$diagnostics"
  return 1
}
export -f compile
printf '%s\n' "$@" | xargs -P 2 -I {} bash -c 'compile "$@"' _ {} "${command[@]}"
echo "$# sources compile"
