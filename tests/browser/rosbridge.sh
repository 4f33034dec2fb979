#!/usr/bin/env bash
# A simulated TurtleBot behind other people's client of rosbridge, driven: rosbridge.sh BUILD STRIATE TURTLEBOT
# [WAY]; WAY is how far it drives through config/worlds/short.yaml, else some metres.
set -euo pipefail
[ $# -ge 3 ] || { echo "usage: rosbridge.sh BUILD STRIATE TURTLEBOT [WAY]" >&2; exit 2; }
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
packages="$(realpath "$1")/tests/browser" striate="$(realpath "$2")" turtlebot="$(realpath "$3")"
command -v node >/dev/null || { echo "error: node is missing; run cmake/install_packages.sh --browser" >&2; exit 1; }
cmp -s "$here/package-lock.json" "$packages/installed.json" || {
  echo "error: its packages are missing; run tests/browser/install.sh $1" >&2
  exit 1
}
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$here/../.."
node "$here/rosbridge.mjs" "$packages" "$striate" "$turtlebot" "$work" "${4:-}"
