#!/usr/bin/env bash
# Every relative link of the documents leads to a file and, behind a #, to a heading of it; the front page stays short;
# scene files point to headings of docs/decisions.md that exist.
set -euo pipefail
cd "$WETDECK_SOURCE"
failed=0
complain() { echo "FAILED: $*"; failed=1; }

# Headings of a document as the anchors that GitHub makes of them.
anchors() {
    awk '/^```/ { code = !code } !code && /^#+ / { sub(/^#+ /, ""); print tolower($0) }' "$1" |
        sed -E 's/[^a-z0-9 _-]//g; s/ /-/g'
}

documents=$(find . -name '*.md' -not -path './build/*' -not -path '*/node_modules/*' -not -path './results/*' | sort)
for document in $documents; do
    folder=$(dirname "$document")
    # no links where the text is code
    links=$(awk '/^```/ { code = !code; next } !code { gsub(/`[^`]*`/, ""); print }' "$document" |
            grep -oE '\]\([^)[:space:]]+\)' | sed -E 's/^\]\(//; s/\)$//' || true)
    for link in $links; do
        [[ $link =~ ^(https?|mailto): ]] && continue
        file=${link%%#*}
        target=${file:+$folder/$file}
        target=${target:-$document}
        [ -e "$target" ] || { complain "$document: no file for the link $link"; continue; }
        [[ $link == *'#'* ]] || continue
        anchors "$target" | grep -qxF -- "${link#*#}" || complain "$document: no heading for the link $link"
    done
done

lines=$(wc -l <README.md)
[ "$lines" -le 120 ] || complain "README.md has $lines lines, expected at most 120"

# (2) to (27) of Yang et al. each have a row in the table of the theory
table=$(grep '^| (' docs/theory.md | sed -E 's/^\| ([^|]*)\|.*/\1/')
covered=" $(sed -E 's/\(([0-9]+)\) to \(([0-9]+)\)/\1 \2/' <<<"$table" | grep -oE '\(?[0-9]+\)?' | tr -d '()' | tr '\n' ' ') "
while read -r low high; do covered+="$(seq -s ' ' "$low" "$high") "; done \
    < <(grep -oE '\([0-9]+\) to \([0-9]+\)' <<<"$table" | tr -d '()' | sed 's/ to / /')
for equation in $(seq 1 27); do
    [[ $covered == *" $equation "* ]] || complain "docs/theory.md has no row for Eq. ($equation)"
done

# "(measured: docs/decisions.md, SCENE, TOPIC)" names a heading, whole or divided by a colon
while read -r pointer; do
    heading=$(sed -E 's/, /: /' <<<"$pointer")
    anchors docs/decisions.md | grep -qxF -- "$(tr '[:upper:] ' '[:lower:]-' <<<"$heading" | tr -d ':')" ||
        complain "a scene points to docs/decisions.md, $pointer: no such heading"
done < <(grep -ohE 'docs/decisions\.md, [^)"]+' validation/scenes/*.toml | sed 's/^docs\/decisions\.md, //' | sort -u)
exit $failed
