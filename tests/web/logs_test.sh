#!/usr/bin/env bash
# The logs of all worlds by the page's machine are those of the desktop:
#   tests/web/logs_test.sh build/release/tests/replan_log_hashes build/web/page/replan_log_hashes.js
set -euo pipefail
native=$(readlink -f "$1") web=$(readlink -f "$2")
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
found=$(mktemp -d)
trap 'rm -rf "$found"' EXIT
"$native" maps/*.json >"$found/native"
# Node.js 18 and later has what this emscripten takes for the sign of a browser.
node --no-experimental-fetch "$web" maps/*.json >"$found/web"
diff "$found/native" "$found/web"
echo "$(wc -l <"$found/web") logs of $(awk '{ n += $3 } END { print n }' "$found/web") events are the same."
