#!/usr/bin/env bash
# The Debian package of the program: what it depends on and what it holds.
set -euo pipefail
for program in dpkg-shlibdeps file cpack; do
    command -v $program >/dev/null || { echo "not tested: needs $program (packages dpkg-dev, file, cmake)"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cpack --config "$WETDECK_BUILD/CPackConfig.cmake" -G DEB -B "$folder" -D CPACK_COMPONENTS_ALL=program >"$folder/log" 2>&1 ||
    { cat "$folder/log"; echo FAILED; exit 1; }
package=$(echo "$folder"/wetdeck_*.deb)
depends=$(dpkg-deb -f "$package" Depends)
for library in libvtk9 libhdf5 libgsl libudunits2 libgomp1 libfmt gnuplot; do
    grep -q "$library" <<<"$depends" || { echo "FAILED: $library is not in: $depends"; exit 1; }
done
# header-only or linked in: what only a build needs must not be installed with the program
if grep -q -- '-dev' <<<"$depends"; then echo "FAILED: depends on a development package: $depends"; exit 1; fi
held=$(dpkg-deb -c "$package")
for file in bin/wetdeck share/man/man1/wetdeck.1 share/wetdeck/scenes/dam_break.toml share/wetdeck/paraview/wetdeck_fields.py \
    share/wetdeck/reference_data/dam_break/buchner2002_pressure_digit1.csv share/doc/wetdeck/copyright; do
    grep -q "\./usr/$file\$" <<<"$held" || { echo "FAILED: no $file"; exit 1; }
done
if grep -q '/include/\|\.a$' <<<"$held"; then echo "FAILED: the libraries are in the program's package"; exit 1; fi
