#!/usr/bin/env bash
# OpenFOAM v1912 of Debian 12 (1912.200626-1+b1) multiplies tensors and vectors in place in every second cell, so that velocities
# which are rebuilt from fluxes are wrong there, without a message.
#
# Seen with potentialFoam on four by four cells of a sheared square. What it should compute (fvcReconstruct.C) is
#     U = inv(SUM S S / |S|) . SUM S phi / |S|
# over the sides of each cell. In the cells with odd numbers U_y is instead T_yx U_x + T_yy v_y, with T the inverse tensor and v the
# sum on the right: the component U_x, which is computed first, has already taken the place of v_x. In cells with even numbers U is
# right to all digits. Cells along the axes have no T_yx, so that nothing is seen on them.
# Where it hurts: interFoam, interIsoFoam and compressibleInterFoam rebuild their velocities so in each step; on slanted cells they
# end in floating-point exceptions or, where the layer of cells is thick, go on with wrong velocities. An interFoam that is compiled
# with -O1 from the sources of the package has no such cells. `wetdeck peer` tests for it (docs/other_codes.md).
#
# Needs apt-get (to download 66 MB of packages, not to install), dpkg and python3. Ends with 0 while the behaviour is as described,
# with 1 once it has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
cd "$folder"
mkdir -p archives/partial root case/system case/constant case/0
apt-get install -qq -y --reinstall --download-only --no-install-recommends -o Debug::NoLocking=true -o APT::Sandbox::User=root \
    -o Dir::Cache::archives="$PWD/archives" openfoam=1912.200626-1+b1 libopenfoam=1912.200626-1+b1 >/dev/null 2>&1
for package in archives/*.deb; do dpkg -x "$package" root; done
export LC_ALL=C WM_PROJECT_DIR="$PWD/root/usr/share/openfoam"
library=root/usr/lib
export LD_LIBRARY_PATH="$PWD/$library:$PWD/$library/$(uname -m)-linux-gnu:$PWD/$library/openmpi-system"
program="$PWD/root/usr/bin"
cd case
put() { # CLASS NAME FILE: the rest of the file from stdin
    { printf 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n' "$1" "$2"; cat; } >"$3"
}
put dictionary blockMeshDict system/blockMeshDict <<'END'
scale 1;
vertices ((0 0 0) (1 0 0) (1.5 1 0) (0.5 1 0) (0 0 1) (1 0 1) (1.5 1 1) (0.5 1 1));
blocks (hex (0 1 2 3 4 5 6 7) (4 4 1) simpleGrading (1 1 1));
boundary
(
    ends { type patch; faces ((0 4 7 3) (1 2 6 5) (0 1 5 4) (3 7 6 2)); }
    sides { type empty; faces ((0 3 2 1) (4 5 6 7)); }
);
END
put dictionary controlDict system/controlDict <<'END'
application potentialFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 12;
END
put dictionary fvSchemes system/fvSchemes <<'END'
ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; } divSchemes { default none; div(div(phi,U)) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
END
put dictionary fvSolution system/fvSolution <<'END'
solvers { Phi { solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0; } }
potentialFlow { nNonOrthogonalCorrectors 20; PhiRefCell 0; PhiRefValue 0; pRefCell 0; pRefValue 0; }
END
put volVectorField U 0/U <<'END'
dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField { ends { type fixedValue; value uniform (1 0 0); } sides { type empty; } }
END
put volScalarField p 0/p <<'END'
dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { ends { type zeroGradient; } sides { type empty; } }
END
for each in blockMesh "potentialFoam -writephi"; do
    # shellcheck disable=SC2086
    "$program"/$each >log 2>&1 || { tail -n 5 log; echo "could not be tried: $each failed"; exit 1; }
done
python3 - <<'END'
import re, sys

def text(name):
    return open(name).read()
def vectors(text):
    return [tuple(map(float, each)) for each in re.findall(r'\(([-\d.e+]+) ([-\d.e+]+) ([-\d.e+]+)\)', text)]
def numbers(text):
    return [float(each) for each in text[text.index('(\n') + 2:].split(')')[0].split()]

points = vectors(text('constant/polyMesh/points'))
faces = [list(map(int, each.split())) for each in re.findall(r'4\(([\d ]+)\)', text('constant/polyMesh/faces'))]
def labels(name):
    lines = text('constant/polyMesh/' + name)
    return [int(each) for each in lines[lines.rindex('\n(\n') + 3:].split(')')[0].split()]
owner, neighbour = labels('owner'), labels('neighbour')
field = text('0/phi')
inner, outer = field[field.index('internalField'):].split('boundaryField')
phi = numbers(inner) + numbers(outer[outer.index('ends'):])  # the faces of the empty sides come last
velocities = vectors(text('0/U').split('boundaryField')[0])

wrong = {'even': [0, 0], 'odd': [0, 0]}  # largest distance from the formula, from the same in place
for cell, seen in enumerate(velocities):
    xx = xy = yy = vx = vy = 0
    for face, flux in enumerate(phi):
        if owner[face] != cell and not (face < len(neighbour) and neighbour[face] == cell):
            continue
        corner = [points[k] for k in faces[face]]
        a = [corner[2][i] - corner[0][i] for i in range(3)]
        b = [corner[3][i] - corner[1][i] for i in range(3)]
        x, y = 0.5 * (a[1] * b[2] - a[2] * b[1]), 0.5 * (a[2] * b[0] - a[0] * b[2])
        size = (x * x + y * y) ** 0.5
        xx, xy, yy = xx + x * x / size, xy + x * y / size, yy + y * y / size
        vx, vy = vx + x * flux / size, vy + y * flux / size
    det = xx * yy - xy * xy
    txx, txy, tyy = yy / det, -xy / det, xx / det
    ux = txx * vx + txy * vy
    for k, uy in enumerate((txy * vx + tyy * vy, txy * ux + tyy * vy)):
        kind = wrong['odd' if cell % 2 else 'even']
        kind[k] = max(kind[k], abs(ux - seen[0]), abs(uy - seen[1]))
for kind, (formula, in_place) in wrong.items():
    print(f'OpenFOAM 1912.200626-1+b1: cells with {kind} numbers: {formula:.1e} from the formula, {in_place:.1e} from the same in place')
tiny = 1e-9
described = wrong['even'][0] < tiny and wrong['odd'][1] < tiny and wrong['odd'][0] > 0.1 and wrong['even'][1] > 0.1
if not described:
    print('the behaviour has changed')
sys.exit(0 if described else 1)
END
