#!/usr/bin/env bash
# The BARN benchmark's worlds with plain DWA and with its fusion: a table, and build/barn.csv with a line for each drive.
# Usage: scripts/barn.sh [FOLDER] [OPTIONS of replan barn]; REPLAN is the program.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-${REPLAN_SHARED_DATA:-../shared/data}/barn}
shift || true
exec "${REPLAN:-build/release/replan}" barn "$folder" --csv build/barn.csv "$@"
