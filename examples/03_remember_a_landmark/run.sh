#!/bin/sh
# usage: run.sh PREFIX BUILD: the installed Striate, and where this example was built
set -eu
"$2/remember" "$2"
# The command opens the memory that the program made.
"$1/bin/striate" memory "$2/home.db" list | grep book
test -s "$2/found.png"
