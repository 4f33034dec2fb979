#!/bin/sh
# usage: run.sh PREFIX BUILD: the installed Striate, and where this example was built
set -eu
"$2/match" "$2"
test -s "$2/matches.png"
