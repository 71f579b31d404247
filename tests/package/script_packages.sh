#!/usr/bin/env bash
# The packages that the script would install on a machine that has none, for a run and for the tests. A stand-in for
# dpkg-query says that nothing is installed; the copied script has no build folder, so that it looks.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin"
printf '#!/bin/sh\n' >"$folder/bin/dpkg-query"
chmod +x "$folder/bin/dpkg-query"
cp "$WETDECK_SOURCE/wetdeck" "$folder/wetdeck"
fail() { echo "FAILED: $*" >&2; exit 1; }

missing() { # ARGUMENT: the packages that the script names for this command
    local status=0
    PATH=$folder/bin:$PATH WETDECK_NO_INSTALL=1 "$folder/wetdeck" "$1" 2>"$folder/said" || status=$?
    [ $status = 4 ] || fail "$1: exit code $status, expected 4: $(cat "$folder/said")"
    sed -n 's/^wetdeck: missing packages: //p' "$folder/said"
}
for_run=" $(missing list) " for_tests=" $(missing test) "
for package in g++ cmake ninja-build libhdf5-dev libvtk9-dev gnuplot-nox; do
    [[ $for_run == *" $package "* ]] || fail "a run lacks $package: $for_run"
done
for package in catch2 librapidcheck-dev file dpkg-dev groff-base doxygen; do
    [[ $for_run != *" $package "* ]] || fail "a run does not need $package: $for_run"
    [[ $for_tests == *" $package "* ]] || fail "the tests lack $package: $for_tests"
done
for package in $for_run; do
    [[ $for_tests == *" $package "* ]] || fail "the tests lack $package, which a run needs: $for_tests"
done
