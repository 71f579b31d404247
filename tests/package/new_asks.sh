#!/usr/bin/env bash
# On a terminal `wetdeck new` asks for what is missing, and again where the answer is no positive number.
set -euo pipefail
command -v script >/dev/null || { echo "not tested: no script (bsdutils), which makes a terminal"; exit 77; }
script -qec true /dev/null >/dev/null 2>&1 || { echo "not tested: this machine makes no terminals (/dev/pts)"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
printf '0, 0\n0.25, 0.09\n0.25, 0.2\n-0.25, 0.2\n-0.25, 0.09\n' >hull.csv
fail() { echo "FAILED: $*" >&2; cat said >&2; exit 1; }
ask() { # ANSWERS
    local status=0
    rm -f mine.toml
    printf "%b" "$1" | script -qec "'$WETDECK_PROGRAM' new hull.csv --out mine.toml" /dev/null >said || status=$?
    [ "$status" = 0 ] || fail "exit code $status for the answers $1"
}
ask 'fast\n-3\n3\n60\n\n\n\n'
grep -q 'speed downwards at which the keel meets the water \[m/s\]' said || fail "no question for the speed"
[ "$(grep -c 'expected a positive number' said)" = 2 ] || fail "two answers were no positive numbers"
grep -q '^mass = 60 ' mine.toml || fail "no mass of 60 kg/m"
grep -q '^air = false' mine.toml || fail "air, though nobody wanted it"
ask '3\n60\n0.83\n0.005\ny\n'
grep -q '^surface = 0.83 ' mine.toml || fail "no depth of 0.83 m"
grep -q '^air = true' mine.toml || fail "no air"
"$WETDECK_PROGRAM" check --strict mine.toml >/dev/null || fail "check doubts the scene"
