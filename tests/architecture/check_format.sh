#!/bin/sh
# Every C++ file is as clang-format would write it.
cd "$(dirname "$0")/../.." || exit 1
find base examples config perception memory behaviours tasks platform agent evaluation app python tests -name '*.cpp' -o -name '*.hpp' | sort |
  xargs "$1" --dry-run --Werror
