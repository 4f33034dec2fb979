#!/usr/bin/env bash
# Puts the packages of package-lock.json into a build folder: install.sh BUILD
# Does nothing where they are there already.
set -euo pipefail
[ $# -eq 1 ] || { echo "usage: install.sh BUILD" >&2; exit 2; }
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
folder="$1/tests/browser"
mkdir -p "$folder"
cmp -s "$here/package-lock.json" "$folder/installed.json" && exit 0
command -v npm >/dev/null || { echo "error: npm is missing; run cmake/install_packages.sh --browser" >&2; exit 1; }
cp "$here/package.json" "$here/package-lock.json" "$here/.npmrc" "$folder"
(cd "$folder" && npm ci --silent)
cp "$here/package-lock.json" "$folder/installed.json"
