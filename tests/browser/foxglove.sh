#!/usr/bin/env bash
# Robots that run, seen and led by other people's client of the Foxglove protocol: foxglove.sh BUILD STRIATE
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: foxglove.sh BUILD STRIATE" >&2; exit 2; }
striate="$(realpath "$2")"
source "$(dirname "${BASH_SOURCE[0]}")/with_packages.sh" "$1"
node "$here/watch_robot.mjs" "$packages" "$striate" "$work"
