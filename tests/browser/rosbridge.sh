#!/usr/bin/env bash
# A simulated TurtleBot behind other people's client of rosbridge, driven: rosbridge.sh BUILD STRIATE TURTLEBOT
# [WAY]; WAY is how far it drives through config/worlds/short.yaml, else some metres.
set -euo pipefail
[ $# -ge 3 ] || { echo "usage: rosbridge.sh BUILD STRIATE TURTLEBOT [WAY]" >&2; exit 2; }
striate="$(realpath "$2")" turtlebot="$(realpath "$3")"
source "$(dirname "${BASH_SOURCE[0]}")/with_packages.sh" "$1"
node "$here/rosbridge.mjs" "$packages" "$striate" "$turtlebot" "$work" "${4:-}"
