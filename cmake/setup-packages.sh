#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# setup-packages.sh PACKAGE...: install those of these Debian packages that are missing; where that cannot be done, name
# them and fail.
set -euo pipefail

stop() {
  echo "$1 Install these (Debian's names), then use the CMake presets (cmake --list-presets): $2" >&2
  exit 1
}

command -v apt-get >/dev/null && command -v dpkg-query >/dev/null || stop "This is not Debian or Ubuntu." "$*"

missing=()
for package in "$@"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID)); then
  command -v sudo >/dev/null || stop "Packages are missing, and neither root nor sudo is at hand." "${missing[*]}"
  as_root=(sudo)
fi
echo "Installing ${missing[*]}" >&2
${as_root[@]+"${as_root[@]}"} apt-get update -qq
${as_root[@]+"${as_root[@]}"} env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
  "${missing[@]}"
