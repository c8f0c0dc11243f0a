#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# same_as_readme.sh README.md SOURCE NAME: the block of C++ below the line of README.md that shows NAME is SOURCE.
set -euo pipefail
readme=$1
source=$2
name=$3

shown=$(awk -v name="$name" '
  index($0, "`" name "`, whole:") { wanted = 1 }
  /^```$/ && copying { exit }
  copying { print }
  /^```cpp$/ && wanted { copying = 1 }' "$readme")
[[ $shown ]] || { echo "FAILED: $readme shows no \`$name\`, whole"; exit 1; }
diff <(echo "$shown") "$source" || { echo "FAILED: $readme shows another $name"; exit 1; }
