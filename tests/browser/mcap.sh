#!/usr/bin/env bash
# Our MCAP files read by other people's code, and theirs by ours: mcap.sh BUILD STRIATE MCAP_LISTING
set -euo pipefail
[ $# -eq 3 ] || { echo "usage: mcap.sh BUILD STRIATE MCAP_LISTING" >&2; exit 2; }
striate="$(realpath "$2")" listing="$(realpath "$3")"
source "$(dirname "${BASH_SOURCE[0]}")/with_packages.sh" "$1"

"$striate" run config/tasks/corridor.yaml --world config/worlds/short.yaml --seed 3 --var "way=2 m" \
  --memory "$work/new.db" --record "$work/run.rec" --mcap "$work/zstd.mcap" --quiet
for compression in lz4 none; do
  "$striate" export "$work/run.rec" --mcap "$work/$compression.mcap" --compression "$compression" --quiet
done
node "$here/check_ours.mjs" "$packages" "$work/zstd.mcap" "$work/lz4.mcap" "$work/none.mcap"

for compression in zstd lz4 none; do
  node "$here/write_theirs.mjs" "$packages" "$work/theirs.mcap" "$compression" > "$work/written.txt"
  "$listing" "$work/theirs.mcap" > "$work/read.txt"
  diff "$work/written.txt" "$work/read.txt"
done
echo "files of @mcap/core are read to their last message"
