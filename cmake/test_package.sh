#!/usr/bin/env bash
# Installs the Debian package into a bare Debian 12 and drives a short mission there, from a folder that
# is not the source tree. Run it as root.
#   cmake/test_package.sh DEB             makes the bare system with debootstrap, in a temporary folder
#   cmake/test_package.sh DEB ROOT        uses the system in ROOT, and leaves it changed
# STRIATE_PYTHON_DEB: python3-striate, which is installed and used beside it; without it that is left out.
# STRIATE_MIRROR: where Debian's packages come from (http://deb.debian.org/debian).
set -euo pipefail
[ $# -ge 1 ] && [ $# -le 2 ] || { sed -n '2,7s/^# \?//p' "$0" >&2; exit 2; }
[ "$(id -u)" -eq 0 ] || { echo "error: chroot needs root" >&2; exit 2; }
deb=$(realpath "$1")
mirror=${STRIATE_MIRROR:-http://deb.debian.org/debian}

made=  # the folder that we made and may delete; never one that was given
if [ $# -eq 2 ]; then
  root=$(realpath "$2")
else
  command -v debootstrap >/dev/null || { echo "error: install debootstrap, or name a root folder" >&2; exit 2; }
  made=$(mktemp -d)
  root=$made
fi
cleanup() {
  umount "$root/proc" 2>/dev/null || true
  [ -z "$made" ] || rm -rf --one-file-system "$made"
}
trap cleanup EXIT
[ -z "$made" ] || debootstrap --variant=minbase bookworm "$root" "$mirror" >/dev/null

# Nothing of this machine's environment.
inside() { chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"; }
cp "$deb" "$root/striate.deb"
[ -z "${STRIATE_PYTHON_DEB:-}" ] || cp "$STRIATE_PYTHON_DEB" "$root/python3-striate.deb"
cp /etc/resolv.conf "$root/etc/resolv.conf"
mount -t proc proc "$root/proc"

echo "== installs"
apt() { inside env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 "$@" >/dev/null; }
apt update
apt install -y --no-install-recommends /striate.deb
inside dpkg -s striate | grep -E '^(Status|Version|Installed-Size)'

share=/usr/share/striate/config
echo "== runs, from /tmp"
inside env -C /tmp striate --version
inside env -C /tmp striate check $share/tasks/corridor.yaml $share/worlds/short.yaml
inside env -C /tmp striate run $share/tasks/corridor.yaml --world $share/worlds/short.yaml --seed 3 --result /tmp/result.json
inside test -s /tmp/result.json
inside test -s /usr/share/bash-completion/completions/striate
if [ -n "${STRIATE_PYTHON_DEB:-}" ]; then
  echo "== the Python module"
  apt install -y --no-install-recommends /python3-striate.deb
  inside env -C /tmp python3 -c "
import striate
print(striate.__version__, striate.run('corridor', world='short', seed=3).outcome)"
  apt purge -y python3-striate
fi
echo "== is removed without a trace"
apt purge -y striate
[ -z "$(inside find /usr /etc -name '*striate*')" ] || { echo "error: files are left" >&2; exit 1; }
echo "the package works on a bare Debian 12"
