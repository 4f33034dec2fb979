#!/usr/bin/env bash
# A person's stories with the dashboard, in headless Chromium: dashboard.sh BUILD STRIATE STORIES
# Screenshots are written to BUILD/tests/browser/screens.
set -euo pipefail
[ $# -eq 3 ] || { echo "usage: dashboard.sh BUILD STRIATE STORIES" >&2; exit 2; }
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
packages="$(realpath "$1")/tests/browser" striate="$(realpath "$2")"
for program in node chromium; do
  command -v "$program" >/dev/null || { echo "error: $program is missing; run cmake/install_packages.sh --browser" >&2; exit 1; }
done
cmp -s "$here/package-lock.json" "$packages/installed.json" || {
  echo "error: its packages are missing; run tests/browser/install.sh $1" >&2
  exit 1
}
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
mkdir -p "$packages/screens"
cd "$here/../.."
CHROMIUM="$(command -v chromium)" node "$here/dashboard_$3.mjs" "$packages" "$striate" "$work" "$packages/screens"
