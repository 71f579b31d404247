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
peer plate flat_plate --variant constant-velocity --dx 0.008 --cells 0.7,1 --until 0.0078
within "$(value plate force_peak)" 77400 85600 "force peak of the plate [N/m] (81500 within 5 %)"
within "$(value plate impulse_2ms)" 143.6 158.8 "impulse of the plate [N s/m] (151.2 within 5 %)"

# A section that gmsh meshes: the mesh is sound, is the one that gmshToFoam makes of the same geometry, and the solver starts.
for program in gmsh gmshToFoam checkMesh transformPoints; do
    command -v $program >/dev/null || { echo "sections are not tested: $program is missing (apt install gmsh)"; exit 0; }
done
export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}"
case="$folder/heeled"
"$WETDECK_PROGRAM" export openfoam heeled_wedge --dx 0.02 --until 0.001 --out "$case" >/dev/null || fail "export of a heeled wedge"
(cd "$case" && checkMesh) >"$folder/log" 2>&1
grep -q "^Mesh OK" "$folder/log" || { cat "$folder/log"; fail "checkMesh on the mesh of a heeled wedge"; }
sizes() { # LOG OF checkMesh: cells, and sides on each patch but front and back
    awk '/ hexahedra:/ { print "cells", $2 } /^ *(atmosphere|body|inflow|walls) / { print $1, $2 }' "$1" | sort
}
mkdir -p "$folder/other/system" "$folder/other/constant"
cp "$case"/system/* "$folder/other/system"
{
    grep -v "^Physical" "$case/section.geo"
    echo 'o[] = Extrude {0, 0, 1} { Surface{1}; Layers{1}; Recombine; };'
    echo 'Physical Volume("fluid") = {o[1]}; Physical Surface("sides") = {1, o[0]}; Physical Surface("inflow") = {o[2]};'
    echo 'Physical Surface("walls") = {o[3], o[5]}; Physical Surface("atmosphere") = {o[4]}; Physical Surface("body") = {o[6], o[7], o[8]};'
} >"$folder/other/section.geo"
(cd "$folder/other" && gmsh -3 -format msh22 -o section.msh section.geo && gmshToFoam section.msh && checkMesh >checked) >"$folder/log2" 2>&1 ||
    { cat "$folder/log2"; fail "gmshToFoam"; }
[[ "$(sizes "$folder/log")" == "$(sizes "$folder/other/checked")" ]] ||
    { sizes "$folder/log"; sizes "$folder/other/checked"; fail "gmshToFoam makes another mesh of the geometry"; }
# a thick layer hides the fault of some builds as far as is needed to see that the case runs
(cd "$case" && transformPoints -scale '(1 1 1000)' && sed -i 's/ 0\.5)$/ 500)/' system/controlDict && ./run.sh) >"$folder/log" 2>&1 ||
    { tail -n 20 "$folder/log"; fail "the case of a heeled wedge does not run"; }

# A build that computes its slanted cells wrongly is refused in one line, with the fault's name.
if [[ "$(dpkg-query -W -f '${Version}' openfoam 2>/dev/null)" == "1912.200626-1+b1" ]]; then
    "$WETDECK_PROGRAM" peer openfoam heeled_wedge --dx 0.015 --out "$folder/refused" >"$folder/log" 2>&1 && fail "a faulty build went through"
    [[ $(wc -l <"$folder/log") == 1 ]] || { cat "$folder/log"; fail "more than one line on a faulty build"; }
    grep -q "multiplies a tensor and a vector in place" "$folder/log" || { cat "$folder/log"; fail "the fault is not named"; }
fi
