#!/usr/bin/env bash
# Doxygen over the installed headers, then over the solver's public ones with every undocumented member an error.
set -euo pipefail
command -v doxygen >/dev/null || { echo "not tested: needs doxygen"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
settings=$WETDECK_BUILD/docs/Doxyfile
(cat "$settings"; echo "OUTPUT_DIRECTORY = $folder") | doxygen - || { echo "FAILED: API pages"; exit 1; }
grep -q "Vec2 corner\|section_drop" "$folder/html/index.html" || { echo "FAILED: the main page lacks the example"; exit 1; }
# the passes over pairs and their lists are no part of the interface
{
    cat "$settings"
    printf '%s\n' "OUTPUT_DIRECTORY = $folder/strict" "INPUT = $WETDECK_SOURCE/solver" "FILE_PATTERNS = *.hpp" \
        "EXCLUDE = $WETDECK_SOURCE/solver/passes $WETDECK_SOURCE/solver/neighbours" "USE_MDFILE_AS_MAINPAGE =" \
        "EXTRACT_ALL = NO" "WARN_IF_UNDOCUMENTED = YES"
} | doxygen - || { echo "FAILED: parts of the solver's interface are not described"; exit 1; }
