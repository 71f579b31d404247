#!/usr/bin/env bash
# What the script at the root says while it installs and builds: what both will take, how far they are, what is missing
# in the end. Stand-ins for apt-get, dpkg-query, id, cmake and ninja take the place of the real ones.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/root"
cp "$WETDECK_SOURCE/wetdeck" "$folder/root/wetdeck"
for name in CMakeLists.txt CMakePresets.json cmake docs solver validation reports reference_data tests; do
    touch "$folder/root/$name"
done
fail() { echo "FAILED: $*" >&2; cat "$folder/said" >&2; exit 1; }
stand_in() { # NAME, with its text on stdin
    { echo '#!/bin/bash'; cat; } >"$folder/bin/$1"
    chmod +x "$folder/bin/$1"
}
stand_in dpkg-query </dev/null
stand_in id <<<'echo 0'
stand_in apt-get <<'END'
case "$*" in
    *--assume-no*)
        echo '0 upgraded, 927 newly installed, 0 to remove and 0 not upgraded.'
        echo 'Need to get 547 MB/600 MB of archives.'
        echo 'After this operation, 2285 MB of additional disk space will be used.' ;;
    *update*) echo 'Get:1 http://deb.debian.org/debian bookworm InRelease' ;;
    *) printf 'Get:1 a\nGet:2 b\nUnpacking a (1) ...\nSetting up a (1) ...\n'
       [ -f "$FOLDER/quick" ] || sleep 11
       touch "$FOLDER/quick"
       [ ! -f "$FOLDER/broken" ] ;;
esac
END
stand_in ninja <<<'seq 258'
stand_in cmake <<'END'
[ "$1" = --build ] || exit 0
mkdir -p "$2/reports/assets"
touch "$2/reports/assets/plotly.stamp"
[ ! -f "$FOLDER/with_plotly" ] || touch "$2/reports/assets/plotly.min.js"
printf '[1/258] Building a\n[17/258] Building b\n'
printf '#!/bin/sh\necho "the program: $*"\n' >"$2/wetdeck"
chmod +x "$2/wetdeck"
END
call() { # ARGUMENTS: the exit code in `status`, what was said in $folder/said
    status=0
    FOLDER=$folder PATH=$folder/bin:$PATH "$folder/root/wetdeck" "$@" >"$folder/out" 2>"$folder/said" </dev/null || status=$?
}
says() { grep -qE -- "$1" "$folder/said" || fail "it does not say: $1"; }
is_silent_about() { ! grep -qE -- "$1" "$folder/said" || fail "it says: $1"; }

call list --json
[ $status = 0 ] || fail "exit code $status"
grep -qx 'the program: list --json' "$folder/out" || fail "the program was not called with the arguments"
says '^wetdeck: installing g\+\+ cmake '
says '927 packages, 547 MB to load, 2285 MB on the disk \(.* free\), 2 min to 7 min by the disk \(log: .*install\.log\)'
says '^wetdeck: 2 of 927 packages loaded, 1 unpacked, 1 set up, 1[0-9] s'
says '^wetdeck: building into .*: 258 steps, about .* with [0-9]+ cores?, [0-9]+ MB on the disk \(.* free; log: .*build\.log\)'
says 'could not be taken with npm'
says '^wetdeck: for interactive figures: .*plotly\.stamp'

call describe wedge
[ $status = 0 ] || fail "exit code $status"
[ ! -s "$folder/said" ] || fail "up to date, it says something"

touch "$folder/with_plotly" "$folder/root/solver"
call list
says 'building what has changed'
is_silent_about plotly

touch "$folder/broken" "$folder/root/solver"
call list
[ $status = 4 ] || fail "exit code $status where apt-get failed, expected 4"
says 'apt-get failed, see .*install\.log'
