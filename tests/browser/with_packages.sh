# Sourced by the scripts of this folder as `with_packages.sh BUILD [PROGRAM...]`: sees that node, the programs and
# the packages below BUILD are there; gives `here`, `packages` and a folder `work`; goes to the root of the sources.
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
packages="$(realpath "$1")/tests/browser"
for program in node "${@:2}"; do
  command -v "$program" >/dev/null || { echo "error: $program is missing; run cmake/install_packages.sh --browser" >&2; exit 1; }
done
cmp -s "$here/package-lock.json" "$packages/installed.json" || {
  echo "error: its packages are missing; run tests/browser/install.sh $1" >&2
  exit 1
}
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$here/../.."
