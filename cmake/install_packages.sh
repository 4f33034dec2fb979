#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing, and with --ros those of
# packages_ros.txt; asks for nothing where none is.
set -euo pipefail
folder="$(dirname "${BASH_SOURCE[0]}")"
lists=("$folder/packages.txt")
[ "${1:-}" = --ros ] && lists+=("$folder/packages_ros.txt")

missing=()
while read -r package; do
  case "$package" in ''|'#'*) continue ;; esac
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$package")
done < <(cat "${lists[@]}")
[ ${#missing[@]} -eq 0 ] && exit 0

echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "error: these packages are missing; run as root: apt-get install ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
