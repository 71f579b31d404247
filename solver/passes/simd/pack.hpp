// SPDX-License-Identifier: BSD-3-Clause
// Eight doubles that are computed on together. Included only by the translation units of the passes, which
// are compiled once per instruction set: WETDECK_ISA names the namespace, so that no symbol of one set is
// linked into another. WETDECK_PLAIN_SIMD leaves out the intrinsics of x86 processors.
#pragma once

#if defined(__AVX512F__) && !defined(WETDECK_PLAIN_SIMD)
#define WETDECK_AVX512
#include <immintrin.h>
#endif

#include <cmath>

namespace wetdeck::WETDECK_ISA {

inline constexpr int pack_width = 8;

struct Pack {
    typedef double Lanes __attribute__((vector_size(64)));
    typedef long long MaskLanes __attribute__((vector_size(64)));
    struct Mask {
        MaskLanes lanes;
    };

    Lanes lanes;

    Pack() = default;
    Pack(Lanes v) : lanes(v) {}
    Pack(double v) : lanes(Lanes{v, v, v, v, v, v, v, v}) {}
};

#define WETDECK_INLINE [[gnu::always_inline]] inline

WETDECK_INLINE Pack operator+(Pack a, Pack b) {
    return a.lanes + b.lanes;
}
WETDECK_INLINE Pack operator-(Pack a, Pack b) {
    return a.lanes - b.lanes;
}
WETDECK_INLINE Pack operator-(Pack a) {
    return -a.lanes;
}
WETDECK_INLINE Pack operator*(Pack a, Pack b) {
    return a.lanes * b.lanes;
}
WETDECK_INLINE Pack operator/(Pack a, Pack b) {
    return a.lanes / b.lanes;
}
WETDECK_INLINE Pack& operator+=(Pack& a, Pack b) {
    return a = a + b;
}
WETDECK_INLINE Pack::Mask operator>(Pack a, Pack b) {
    return {a.lanes > b.lanes};
}
WETDECK_INLINE Pack::Mask operator<(Pack a, Pack b) {
    return {a.lanes < b.lanes};
}
WETDECK_INLINE Pack::Mask operator|(Pack::Mask a, Pack::Mask b) {
    return {a.lanes | b.lanes};
}
WETDECK_INLINE Pack select(Pack::Mask m, Pack a, Pack b) {
    return m.lanes ? a.lanes : b.lanes;
}

#if defined(WETDECK_AVX512)
WETDECK_INLINE Pack maximum(Pack a, Pack b) {
    return Pack::Lanes(_mm512_max_pd(__m512d(a.lanes), __m512d(b.lanes)));
}
WETDECK_INLINE Pack minimum(Pack a, Pack b) {
    return Pack::Lanes(_mm512_min_pd(__m512d(a.lanes), __m512d(b.lanes)));
}
/// 1/sqrt(x) and sqrt(x) for x > 0, from a 14-bit estimate y: with e = 1 - x y^2 the series
/// 1/sqrt(x) = y (1 + e/2 + 3 e^2/8 + 5 e^3/16) is exact to rounding.
WETDECK_INLINE void square_roots(Pack x, Pack& root, Pack& inverse_root) {
    const Pack estimate = Pack::Lanes(_mm512_rsqrt14_pd(__m512d(x.lanes)));
    const Pack product = x * estimate;
    const Pack error = 1.0 - product * estimate;
    const Pack correction = error * (0.5 + error * (0.375 + error * 0.3125));
    root = product + product * correction;
    inverse_root = estimate + estimate * correction;
}
WETDECK_INLINE bool any_less(Pack a, Pack b) {
    return _mm512_cmp_pd_mask(__m512d(a.lanes), __m512d(b.lanes), _CMP_LT_OQ) != 0;
}
/// Turns a square of eight packs: what was the n-th number of the k-th becomes the k-th of the n-th.
WETDECK_INLINE void turn(Pack::Lanes (&a)[pack_width]) {
    Pack::Lanes b[pack_width];
    for (int n = 0; n < pack_width; n += 2) {
        b[n] = __builtin_shufflevector(a[n], a[n + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        b[n + 1] = __builtin_shufflevector(a[n], a[n + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int n = 0; n < pack_width; ++n) {
        const int low = n & ~2;
        a[n] = (n & 2) != 0 ? __builtin_shufflevector(b[low], b[low + 2], 2, 3, 10, 11, 6, 7, 14, 15)
                            : __builtin_shufflevector(b[low], b[low + 2], 0, 1, 8, 9, 4, 5, 12, 13);
    }
    for (int n = 0; n < pack_width; ++n) {
        const int low = n & ~4;
        b[n] = (n & 4) != 0 ? __builtin_shufflevector(a[low], a[low + 4], 4, 5, 6, 7, 12, 13, 14, 15)
                            : __builtin_shufflevector(a[low], a[low + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    }
    for (int n = 0; n < pack_width; ++n) a[n] = b[n];
}
/// rows[k] holds eight numbers; columns[n] receives the n-th of each.
WETDECK_INLINE void transpose(const double* const (&rows)[pack_width], Pack (&columns)[pack_width]) {
    Pack::Lanes a[pack_width];
    for (int n = 0; n < pack_width; ++n) a[n] = Pack::Lanes(_mm512_load_pd(rows[n]));
    turn(a);
    for (int n = 0; n < pack_width; ++n) columns[n] = a[n];
}
/// The way back; several rows may be the same place, which then receives the last of them.
WETDECK_INLINE void transpose(const Pack (&columns)[pack_width], double* const (&rows)[pack_width]) {
    Pack::Lanes a[pack_width];
    for (int n = 0; n < pack_width; ++n) a[n] = columns[n].lanes;
    turn(a);
    for (int n = 0; n < pack_width; ++n) _mm512_store_pd(rows[n], __m512d(a[n]));
}
#else
WETDECK_INLINE Pack maximum(Pack a, Pack b) {
    return a.lanes > b.lanes ? a.lanes : b.lanes;
}
WETDECK_INLINE Pack minimum(Pack a, Pack b) {
    return a.lanes < b.lanes ? a.lanes : b.lanes;
}
WETDECK_INLINE void square_roots(Pack x, Pack& root, Pack& inverse_root) {
    for (int lane = 0; lane < pack_width; ++lane) root.lanes[lane] = std::sqrt(x.lanes[lane]);
    inverse_root = 1.0 / root;
}
WETDECK_INLINE bool any_less(Pack a, Pack b) {
    const Pack::Mask less = a < b;
    long long bits = 0;
    for (int lane = 0; lane < pack_width; ++lane) bits |= less.lanes[lane];
    return bits != 0;
}
WETDECK_INLINE void transpose(const double* const (&rows)[pack_width], Pack (&columns)[pack_width]) {
    for (int n = 0; n < pack_width; ++n)
        for (int lane = 0; lane < pack_width; ++lane) columns[n].lanes[lane] = rows[lane][n];
}
WETDECK_INLINE void transpose(const Pack (&columns)[pack_width], double* const (&rows)[pack_width]) {
    for (int lane = 0; lane < pack_width; ++lane)
        for (int n = 0; n < pack_width; ++n) rows[lane][n] = columns[n].lanes[lane];
}
#endif

WETDECK_INLINE Pack positive_part(Pack a) {
    return maximum(a, 0.0);
}

}  // namespace wetdeck::WETDECK_ISA
