#!/usr/bin/env bash
# Builds Striate for arm64 on another machine and runs its unit tests under qemu's user emulation.
#   cmake/test_arm64.sh [WORK [LAYER...]]
# WORK (build/arm64) takes some 2 GB: Debian 12's arm64 packages, unpacked, and the build. What is there
# is used again. Each LAYER (base config perception memory) is built with those below it and tested.
# Debian's packages alone are downloaded; arm64 is not registered on this machine, with apt or binfmt.
# STRIATE_MIRROR: where Debian's packages come from (http://deb.debian.org/debian).
# QEMU_CPU: the processor (max; qemu-aarch64-static -cpu help lists them).
set -euo pipefail
case "${1:-}" in -*) sed -n '2,8s/^# \?//p' "$0" >&2; exit 2 ;; esac
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(realpath -m "${1:-$source_dir/build/arm64}")
layers=("${@:2}")
[ ${#layers[@]} -gt 0 ] || layers=(base config perception memory)
mirror=${STRIATE_MIRROR:-http://deb.debian.org/debian}
root=$work/root
build=$work/build
jobs=$(nproc)
export QEMU_CPU=${QEMU_CPU:-max}

for layer in "${layers[@]}"; do
  ls "$source_dir/tests/unit/$layer/"*_test.cpp >/dev/null 2>&1 || {
    echo "error: there is no layer '$layer' with unit tests; tests/unit has one folder a layer" >&2; exit 2; }
done

"$source_dir/cmake/install_packages.sh" --arm64

# ROS is left out: no unit test of these layers needs it.
wanted="libc6-dev $(grep -E -- '-dev$' "$source_dir/cmake/packages.txt" | tr '\n' ' ')"

# apt with a state of its own, in which nothing is installed and all is arm64. libopencv-dev and others are
# not "Multi-Arch: same", so arm64's cannot be installed beside this machine's.
private_apt() {
  local apt=$work/apt
  mkdir -p "$apt/lists/partial" "$apt/archives/partial"
  : >"$apt/status"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror bookworm main" >"$apt/sources.list"
  cat >"$apt/apt.conf" <<EOF
APT::Architecture "arm64";
APT::Architectures { "arm64"; };
APT::Install-Recommends "false";
APT::Sandbox::User "";
Dir::State "$apt";
Dir::State::lists "$apt/lists";
Dir::State::status "$apt/status";
Dir::Cache "$apt";
Dir::Cache::archives "$apt/archives";
Dir::Etc::SourceList "$apt/sources.list";
Dir::Etc::SourceParts "/dev/null";
Dir::Etc::Preferences "/dev/null";
Dir::Etc::PreferencesParts "/dev/null";
EOF
  APT_CONFIG=$apt/apt.conf apt-get -qq -o Dpkg::Use-Pty=0 "$@" >/dev/null
}

# What the packages' own scripts would have done, of which none is run.
finish_root() {
  local link to
  # Links from / would lead to this machine's files.
  find "$root" -type l -lname '/*' | while read -r link; do
    to=$root$(readlink "$link")
    [ ! -e "$to" ] || ln -sfnr "$to" "$link"
  done
  for name in blas lapack; do  # update-alternatives
    ln -sfn "$name/lib$name.so.3" "$root/usr/lib/aarch64-linux-gnu/lib$name.so.3"
  done
}

if [ "$(cat "$root/unpacked" 2>/dev/null)" != "$wanted" ]; then
  echo "== downloads Debian's arm64 packages"
  private_apt update
  # shellcheck disable=SC2086  # a list
  private_apt install -y --download-only $wanted
  echo "== unpacks them into $root"
  rm -rf --one-file-system "$root"
  mkdir -p "$root"/usr/{bin,sbin,lib}
  for folder in bin sbin lib; do ln -s "usr/$folder" "$root/$folder"; done
  for deb in "$work"/apt/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$deb" | tar -x -C "$root" --keep-directory-symlink --no-same-owner \
      --exclude='./usr/share/doc/*' --exclude='./usr/share/man/*' --exclude='./usr/share/locale/*'
  done
  finish_root
  rm -rf --one-file-system "$work/apt"
  echo "$wanted" >"$root/unpacked"
fi

echo "== builds ${layers[*]/#/unit_}"
cmake -G Ninja -S "$source_dir" -B "$build" --toolchain "$source_dir/cmake/arm64_toolchain.cmake" \
  -DSTRIATE_ARM64_ROOT="$root" -DSTRIATE_ROS=OFF -DSTRIATE_TESTS=ON >/dev/null
cmake --build "$build" -j "$jobs" --target "${layers[@]/#/unit_}"

echo "== runs them on qemu's $QEMU_CPU"
emulated() { qemu-aarch64-static -L "$root" "$@"; }
results=$work/results
rm -rf "$results"
mkdir "$results"
failed=0
for layer in "${layers[@]}"; do
  # As many processes as there are cores, each with its share of the tests.
  shards=()
  for ((shard = 0; shard < jobs; ++shard)); do
    GTEST_TOTAL_SHARDS=$jobs GTEST_SHARD_INDEX=$shard emulated "$build/tests/unit_$layer" \
      --gtest_output="json:$results/$layer.$shard.json" >"$results/$layer.$shard.log" 2>&1 &
    shards+=($!)
  done
  ends=0
  for shard in "${shards[@]}"; do wait "$shard" || ends=$?; done
  logs=("$results/$layer".*.log)
  echo "unit_$layer: $(cat "${logs[@]}" | grep -c '^\[       OK \]') tests passed," \
    "$(cat "${logs[@]}" | grep -c '^\[  FAILED  \] .* ms)') failed"
  if [ "$ends" -ne 0 ]; then
    failed=1
    grep -h '^\[  FAILED  \] .* ms)' "${logs[@]}" || echo "  it ended with $ends, see ${logs[*]}"
  fi
done
said=$(sed -n 's/.*"instruction_set": "\(.*\)".*/\1/p' "$results"/*.json)
[ -z "$said" ] || echo "the vector code ran on $said"
exit $failed
