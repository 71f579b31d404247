#!/usr/bin/env bash
# Installs into a folder of its own, then uses what is there: the program, and the libraries by find_package.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
prefix=$folder/usr
fail() { echo "FAILED: $*" >&2; exit 1; }

"$CMAKE" --install "$WETDECK_BUILD" --prefix "$prefix" >"$folder/install.log" || fail "install: $(cat "$folder/install.log")"

# --- the program
wetdeck=$prefix/bin/wetdeck
cd "$folder"
"$wetdeck" list >list.txt
grep -q dam_break list.txt || fail "list names no dam_break"
"$wetdeck" describe dam_break --json >dam_break.json
grep -q "\"file\": \"$prefix/.*share/wetdeck/scenes/dam_break.toml\"" dam_break.json || fail "another tree's scene"
grep -q "\"file\": \"$prefix/.*share/wetdeck/reference_data/dam_break/" dam_break.json || fail "another tree's data"
grep -q -- '--checkpoint-interval\|\\-\\-checkpoint\\-interval' "$prefix/share/man/man1/wetdeck.1" || fail "no manual page"
[ -f "$prefix/share/bash-completion/completions/wetdeck" ] || fail "no completion"

# --- the libraries, found by the prefix alone
build() { # SOURCE NAME
    { "$CMAKE" -G Ninja -S "$1" -B "$folder/$2" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" &&
        "$CMAKE" --build "$folder/$2"; } >"$folder/$2.log" 2>&1 || fail "$2: $(tail -n 30 "$folder/$2.log")"
}
build "$WETDECK_SOURCE/examples/section_drop" section_drop
said=$("$folder/section_drop/section_drop")
echo "$said"
# The impulse grows as the square of the time since contact, which is known to half a spacing of the 64 mm that the keel
# has gone: 16 %.
awk '{ ratio = $NF; exit !(ratio > 0.84 && ratio < 1.16) }' <<<"$said" || fail "the impulse is not that of the similarity solution"

build "$WETDECK_SOURCE/tests/package/harness" harness
said=$(WETDECK_DATA=$prefix/share/wetdeck "$folder/harness/harness" dam_break "$folder/run")
[ "$said" = "ok front 3" ] || fail "harness: $said"
