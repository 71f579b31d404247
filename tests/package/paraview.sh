#!/usr/bin/env bash
# A picture of a run by ParaView: water, air, walls, body and the colours of the pressure must be in it, and time must move.
# On Debian 12 python3-paraview takes the place of libvtk9-dev: build first, or draw on another machine.
set -euo pipefail
for program in pvpython xvfb-run; do
    command -v $program >/dev/null || { echo "not tested: needs $program (python3-paraview, xvfb)"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export OMP_NUM_THREADS=1
"$WETDECK_PROGRAM" run wedge --variant two-phase --dx 0.02 --until 0.008 --quiet --out "$folder/run" >/dev/null
draw() { # PICTURE TIME
    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython "$WETDECK_SOURCE/validation/paraview/wetdeck_fields.py" \
        "$folder/run" --picture "$1" --time "$2" >"$folder/log" 2>&1 || { cat "$folder/log"; echo FAILED; exit 1; }
}
draw "$folder/first.png" 0
draw "$folder/last.png" 0.008
pvpython "$WETDECK_SOURCE/tests/package/picture_colours.py" "$folder/first.png" "$folder/last.png"
