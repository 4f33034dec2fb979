#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing, and with --ros, --python, --arm64 or --browser
# those of packages_ros.txt, packages_python.txt and so on, too; asks for nothing where none is.
set -euo pipefail
folder="$(dirname "${BASH_SOURCE[0]}")"
lists=("$folder/packages.txt")
for option in "$@"; do
  case "$option" in
    --browser) lists+=("$folder/packages_browser.txt") ;;
    --ros | --python | --arm64) lists+=("$folder/packages_${option#--}.txt") ;;
    *) echo "usage: install_packages.sh [--ros] [--python] [--arm64] [--browser]" >&2; exit 2 ;;
  esac
done

# Node.js of another source brings npm along, and Debian's does not go with it.
has_node() { command -v node >/dev/null && command -v npm >/dev/null; }

missing=()
while read -r package; do
  case "$package" in
    ''|'#'*) continue ;;
    nodejs|npm) has_node && continue ;;
  esac
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
