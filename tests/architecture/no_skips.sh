#!/bin/sh
# No test leaves itself out, least of all because data is missing: a clone judges all that the project's
# own machines judge. What may be left out stands here, as file, number of places, and reason.
allowed='
tests/CMakeLists.txt 1 the ROS 1 component is optional: without its packages there is nothing to test
tests/python/CMakeLists.txt 1 the Python module is optional: without its packages there is nothing to test
tests/scenarios/late_lines_test.cpp 1 pictures in real time; a sanitizer makes the program too slow
tests/scenarios/served_devices_test.cpp 3 pictures in real time; a sanitizer makes the program too slow
'
cd "$(dirname "$0")/../.." || exit 1
words='GTEST_SKIP|SKIP_REGULAR_EXPRESSION|SKIP_RETURN_CODE|TEST(_[FP])?\([A-Za-z0-9_]+, *DISABLED_'
found=$(grep -rEc "$words" tests --include='*.cpp' --include='*.hpp' --include='*.py' --include=CMakeLists.txt |
  grep -v ':0$' | sort)
broken=0
for line in $found; do
  file=${line%:*}
  count=${line##*:}
  may=$(printf '%s' "$allowed" | awk -v file="$file" '$1 == file {print $2}')
  if [ "$count" -gt "${may:-0}" ]; then
    echo "$file: $count places where a test can skip itself, ${may:-0} are allowed:"
    grep -nE "$words" "$file"
    broken=1
  fi
done
if [ "$broken" -ne 0 ]; then
  echo "Ship what the test needs (tests/fixtures/README.md), or make it by rule in the test."
fi
exit "$broken"
