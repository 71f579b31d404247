#!/usr/bin/env bash
# The smallest of each kind of case runs in OpenFOAM, and what it computes is what the scene's references say. Its own job: only where OpenFOAM
# is installed (apt install openfoam).
set -euo pipefail
for program in interFoam compressibleInterFoam python3; do
    command -v $program >/dev/null || { echo "not tested: needs $program (apt install openfoam python3)"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
peer() { # NAME ARGUMENTS...
    local name=$1
    shift
    "$WETDECK_PROGRAM" peer openfoam "$@" --out "$folder/$name" >"$folder/$name.log" 2>&1 || { cat "$folder/$name.log"; fail "peer $*"; }
}
value() { # NAME QUANTITY: on the finest mesh
    python3 -c 'import json, sys
for each in json.load(open(sys.argv[1]))["quantities"]:
    if each["values"]["qoi"] == sys.argv[2]: print(each["values"]["value"][-1])' "$folder/$1/peer.json" "$2"
}
within() { # VALUE LOW HIGH WHAT
    awk -v v="$1" -v low="$2" -v high="$3" 'BEGIN { exit !(low <= v && v <= high) }' || fail "$4 is $1, expected $2 to $3"
}
peer dam_break dam_break --until 0.66 --dx 0.02
within "$(value dam_break arrival_time)" 2.376 2.424 "arrival of the dam break (2.40 within 1 %)"
peer wedge wedge --variant constant-velocity --dx 0.01
within "$(value wedge force_coefficient)" 13.3 14.6 "force coefficient of the wedge (exact 14.02)"
# a heeled section is none of the kinds that can be written: refused in one line
"$WETDECK_PROGRAM" peer openfoam heeled_wedge --out "$folder/heeled" >"$folder/log" 2>&1 && fail "a heeled wedge went through"
[[ $(wc -l <"$folder/log") == 1 ]] || { cat "$folder/log"; fail "more than one line on a heeled wedge"; }
