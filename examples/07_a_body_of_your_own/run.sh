#!/bin/sh
# usage: run.sh PREFIX BUILD: the installed Striate, and where this example was built
set -eu
here=$(dirname "$0")
"$1/bin/striate" check "$here/robot.yaml" --plugin "$2/wall.so"
"$1/bin/striate" run "$here/task.yaml" --robot "$here/robot.yaml" --plugin "$2/wall.so" --result "$2/result.json"
cat "$2/result.json"
# It stood before the wall, 4 m away, and came more than half of the way.
driven=$(sed -n 's/.*"distance_m": \([0-9.]*\).*/\1/p' "$2/result.json")
awk -v driven="$driven" 'BEGIN { exit !(driven > 2.0 && driven < 3.8) }'
