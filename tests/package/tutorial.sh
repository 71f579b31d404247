#!/usr/bin/env bash
# Runs every fenced sh block of both parts of the tutorial in an empty folder, in order, as a reader would.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$WETDECK_SOURCE/docs/tutorial.md" "$WETDECK_SOURCE/docs/tutorial_motion.md" >"$folder/commands.sh"
mkdir "$folder/user" "$folder/bin"
ln -s "$WETDECK_PROGRAM" "$folder/bin/wetdeck"
cd "$folder/user"
OMP_NUM_THREADS=1 PATH=$folder/bin:$PATH bash -exu -o pipefail "$folder/commands.sh" >"$folder/log" 2>&1 || { tail -n 20 "$folder/log"; echo FAILED; exit 1; }
for file in first/index.html first/fields.pvd results/index.html results/summary.json heavier/run.h5 heeled/run.h5 driven/run.h5 half/run.h5 upright.png driven.png plan.svg; do
    [ -s "$file" ] || { echo "FAILED: no $file"; exit 1; }
done
# the measured curve was found and is in both reports
for summary in first/summary.json results/summary.json; do
    for piece in '"reference": "measured"' '"within": true'; do
        grep -q "$piece" "$summary" || { echo "FAILED: $summary lacks $piece"; exit 1; }
    done
done
