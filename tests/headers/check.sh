#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check.sh INCLUDE_DIR COMPILER FLAGS...: compile each header below INCLUDE_DIR/mpm alone and name those that fail.
set -euo pipefail
cd "$1"
shift

compile() {
  local header=$1 diagnostics
  shift
  diagnostics=$(printf '#include <%s>\n#include <%s>\n' "$header" "$header" | "$@" -fsyntax-only -x c++ - 2>&1) &&
    return
  printf 'FAILED: %s does not compile alone\n%s\n' "$header" "$diagnostics"
  return 1
}
export -f compile

headers=$(find mpm -name '*.hpp' | sort)
[[ $headers ]] || { echo "FAILED: no header below $PWD/mpm"; exit 1; }
xargs -P 2 -I {} bash -c 'compile "$@"' _ {} "$@" <<<"$headers"
echo "$(wc -l <<<"$headers") headers compile alone"
