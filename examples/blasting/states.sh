#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# states.sh FOLDER [ARGUMENT...]: blasts five in-situ states into FOLDER, a line each; arguments go to the program.
set -euo pipefail
folder=$1
shift
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mkdir -p "$folder"
for state in 0,0 20,20 50,50 10,40 120,40; do
  h=${state%,*} v=${state#*,}
  printf 'horizontal %s MPa, vertical %s MPa: ' "$h" "$v"
  "$root/run.sh" --set stress.horizontal="$h MPa" --set stress.vertical="$v MPa" --output "$folder/$h-$v" "$@" \
    2>"$folder/$h-$v.log" | tail -n 1
done
