#!/bin/sh
# usage: run.sh PREFIX BUILD: the installed Striate, and where this example was built
set -eu
here=$(dirname "$0")
"$2/mission" "$here/task.yaml" "$here/world.yaml" "$2"
test -s "$2/plan.png"
