#!/bin/sh
# usage: run.sh PREFIX BUILD: the installed Striate, and where this example was built
set -eu
here=$(dirname "$0")
"$1/bin/striate" check "$here/task.yaml" --plugin "$2/change.so"
"$1/bin/striate" run "$here/task.yaml" --plugin "$2/change.so" --world "$1/share/striate/config/worlds/short.yaml"
