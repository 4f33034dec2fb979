#!/usr/bin/env bash
# Robots that run, seen and led by other people's client of the Foxglove protocol: foxglove.sh BUILD STRIATE
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: foxglove.sh BUILD STRIATE" >&2; exit 2; }
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
packages="$(realpath "$1")/tests/browser" striate="$(realpath "$2")"
command -v node >/dev/null || { echo "error: node is missing; run cmake/install_packages.sh --browser" >&2; exit 1; }
cmp -s "$here/package-lock.json" "$packages/installed.json" || {
  echo "error: its packages are missing; run tests/browser/install.sh $1" >&2
  exit 1
}
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$here/../.."
node "$here/watch_robot.mjs" "$packages" "$striate" "$work"
