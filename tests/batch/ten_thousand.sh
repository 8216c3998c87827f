#!/usr/bin/env bash
# A batch of 10 000 runs, killed twice and gone on with, and once more in four processes and merged: the same bytes each time.
#   tests/batch/ten_thousand.sh PROGRAM
set -euo pipefail
replan=$(realpath "$1")
experiment=$(realpath "$(dirname "$0")/experiment.json")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

same() {
  cmp "$1/results.csv" "$2/results.csv"
  cmp "$1/results.json" "$2/results.json"
}

# Starts the batch in the folder, and kills it as soon as so many runs are written down.
killed_after() {
  local process
  "$replan" batch "$experiment" --out "$1" >/dev/null &
  process=$!
  until [[ -f $1/runs.jsonl && $(wc -l <"$1/runs.jsonl") -ge $2 ]]; do
    kill -0 "$process" || { echo "It ended before it could be killed." >&2 && return 1; }
    sleep 0.02
  done
  kill -9 "$process"
  wait "$process" 2>/dev/null || true
}

"$replan" batch "$experiment" --out whole >/dev/null
echo "whole: $(($(wc -l <whole/results.csv) - 1)) runs"
[[ $(wc -l <whole/results.csv) -eq 10001 ]]

killed_after cut 1000
echo "killed with $(wc -l <cut/runs.jsonl) lines"
killed_after cut 5000
echo "killed with $(wc -l <cut/runs.jsonl) lines"
"$replan" batch "$experiment" --out cut --jobs 2 >/dev/null
same whole cut

parts=()
for part in 1 2 3 4; do
  "$replan" batch "$experiment" --out "part-$part" --shard "$part/4" >/dev/null &
  parts+=($!)
done
for part in "${parts[@]}"; do wait "$part"; done
"$replan" merge part-* -o merged >/dev/null
same whole merged
echo "The same bytes, whole, interrupted and in parts."
