#!/usr/bin/env bash
# A person's stories with the dashboard, in headless Chromium: dashboard.sh BUILD STRIATE STORIES
# Screenshots are written to BUILD/tests/browser/screens.
set -euo pipefail
[ $# -eq 3 ] || { echo "usage: dashboard.sh BUILD STRIATE STORIES" >&2; exit 2; }
striate="$(realpath "$2")"
source "$(dirname "${BASH_SOURCE[0]}")/with_packages.sh" "$1" chromium
mkdir -p "$packages/screens"
CHROMIUM="$(command -v chromium)" node "$here/dashboard_$3.mjs" "$packages" "$striate" "$work" "$packages/screens"
