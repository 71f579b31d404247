#!/usr/bin/env bash
# g++ 12.2 (Debian 12) computes a comparison with selection of vectors that are wider than a register number by number;
# additions of the same vectors it splits into registers. -Wall -Wextra say nothing, and -Wvector-operation-performance says
# "expanded piecewise" of both.
#
# Seen with a vector type of eight doubles (vector_size(64)) and -O3 -mavx2, instructions in each function:
#     sum       a + b              2 vaddpd     0 scalar
#     larger    a > b ? a : b      0 vmaxpd     8 vmaxsd
#     by hand   two times four     2 vmaxpd     0 scalar
# clang 14 gives two vmaxpd for all. Where it hurts: particle and lattice codes that choose one width for all instruction sets,
# as AVX-512 suggests: limiters, clamps and masks of their inner loops are then scalar on AVX2 and SSE2. Splitting the
# comparison by hand, or intrinsics, avoids it.
#
# Needs apt-get (to download, not to install), dpkg, and the libraries of any g++ 12 or later. Ends with 0 while the behaviour
# is as described, with 1 once it has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
cd "$folder"
apt-get download -qq g++-12=12.2.0-14+deb12u1 libgmp10 libmpfr6 libmpc3 libisl23 libzstd1 zlib1g 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
compiler=$(find usr/lib/gcc -name cc1plus)
export LD_LIBRARY_PATH="$PWD/usr/lib/x86_64-linux-gnu:$PWD/lib/x86_64-linux-gnu"
cat >wide.cpp <<'SOURCE'
typedef double Eight __attribute__((vector_size(64)));
typedef double Four __attribute__((vector_size(32)));
void sum(Eight* a, const Eight* b) { *a = *a + *b; }
void larger(Eight* a, const Eight* b) { *a = *a > *b ? *a : *b; }
void by_hand(Four* a, const Four* b) {
    for (int k = 0; k < 2; ++k) a[k] = a[k] > b[k] ? a[k] : b[k];
}
SOURCE
"$compiler" -quiet -O3 -mavx2 -Wall -Wextra wide.cpp -o wide.s 2>messages
count() { # FUNCTION INSTRUCTION
    awk -v name="^_Z[0-9]+$1P" -v instruction="$2" '/^_Z/ {inside = $1 ~ name} inside && $1 == instruction {n++} END {print n + 0}' wide.s
}
seen="sum $(count sum vaddpd) $(count sum vaddsd), larger $(count larger vmaxpd) $(count larger vmaxsd), by hand $(count by_hand vmaxpd) $(count by_hand vmaxsd), messages $(wc -l <messages)"
echo "g++ 12.2, packed and scalar instructions: $seen"
[ "$seen" = "sum 2 0, larger 0 8, by hand 2 0, messages 0" ] || { echo "the behaviour has changed"; exit 1; }
