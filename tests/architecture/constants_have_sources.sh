#!/bin/sh
# A threshold is a setting, or a named constant with its unit and where it comes from: fails where
# fewer than 85 % of the named constants of the layers, or of any one layer with twenty or more, say
# both. What counts is written in constants_have_sources.awk. Prints the share of each layer and the
# files with most constants that say too little; with `--list` those constants, one a line.
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.." || exit 1
layers="base config platform perception memory behaviours tasks agent evaluation app python"
counted=$(find $layers -name '*.cpp' -o -name '*.hpp' | sort |
  xargs awk -f "$here/constants_have_sources.awk") || exit 1
if [ "$1" = --list ]; then
  echo "$counted" | grep -v ' sourced unit$'
  exit 0
fi
echo "$counted" | awk -v least=85 '
  {
    ++all[$1]; ++total
    if ($4 == "sourced" && $5 == "unit") { ++good[$1]; ++said; next }
    sub(/:.*/, "", $2)
    ++bare[$2]
  }
  END {
    if (total < 200) { print "only " total " constants were found: is this the source tree?"; exit 1 }
    for (layer in all) {
      share = 100 * good[layer] / all[layer]
      printf "%-11s %4d of %4d named constants have unit and source, %5.1f %%\n", layer, good[layer], all[layer], share
      if (all[layer] >= 20 && share < least) failed = failed " " layer
    }
    printf "%-11s %4d of %4d, %5.1f %%\n", "all", said, total, 100 * said / total
    if (100 * said / total < least) failed = failed " all"
    for (k = 1; k <= 10; ++k) {
      worst = ""
      for (file in bare) if (worst == "" || bare[file] > bare[worst]) worst = file
      if (worst == "") break
      printf "  %3d without in %s\n", bare[worst], worst
      delete bare[worst]
    }
    if (failed != "") {
      print "below " least " %:" failed "; write behind the constant, or above it, its unit and where it comes from"
      print "(tests/architecture/constants_have_sources.sh --list names them)"
      exit 1
    }
  }'
