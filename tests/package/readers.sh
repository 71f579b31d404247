#!/usr/bin/env bash
# Runs the snippets of docs/files.md on a small run with every tool that is there: all must print the same number.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export OMP_NUM_THREADS=1
"$WETDECK_PROGRAM" run dam_break --variant single-phase --dx 0.04 --until 0.1 --quiet --out "$folder/run" >/dev/null
cd "$folder/run"

snippet() { # the fenced block of this name
    awk -v fence="\`\`\`$1" '$0 == fence { inside = 1; next } /^```/ { inside = 0 } inside' "$WETDECK_SOURCE/docs/files.md"
}
tried=0 expected=
check() { # NAME PROGRAM...
    local name=$1 printed
    shift
    snippet "$name" >"$folder/snippet"
    [ -s "$folder/snippet" ] || { echo "docs/files.md has no snippet '$name'"; exit 1; }
    printed=$("$@" "$folder/snippet") || { echo "the snippet '$name' of docs/files.md fails"; exit 1; }
    echo "$name: $printed"
    expected=${expected:-$printed}
    [ "$printed" = "$expected" ] || { echo "'$name' prints $printed, expected $expected"; exit 1; }
    tried=$((tried + 1))
}
for python in python3 /usr/bin/python3; do # Debian's packages are for Debian's own
    "$python" -c 'import h5py' 2>/dev/null && check "python h5py" "$python"
    "$python" -c 'import xarray, h5netcdf' 2>/dev/null && check "python xarray" "$python"
done
command -v ncdump >/dev/null && check "sh ncdump" sh
command -v h5dump >/dev/null && check "sh h5dump" sh
command -v octave-cli >/dev/null && check "octave" octave-cli --no-gui --quiet
[ $tried -ge 2 ] || { echo "not tested: needs two of h5py, xarray, ncdump, h5dump, octave"; exit 77; }
