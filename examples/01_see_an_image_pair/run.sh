#!/bin/sh
# usage: run.sh PREFIX BUILD: the installed Striate, and where this example was built
set -eu
"$2/see" "$2"
test -s "$2/percept.png"
