// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are computed on together: eight doubles. Included only by the translation units of the passes,
// which are compiled once per instruction set: WETDECK_ISA names the namespace, so that no symbol of one set
// is linked into another. WETDECK_PLAIN_SIMD leaves out the intrinsics of x86 processors.
#pragma once

#if defined(__AVX512F__) && !defined(WETDECK_PLAIN_SIMD)
#define WETDECK_AVX512
#include <immintrin.h>
#endif

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace wetdeck::WETDECK_ISA {

inline constexpr int pack_width = 8;

#define WETDECK_INLINE __attribute__((always_inline)) inline

/// `width` numbers. Numbers of any type stand for a pack of equal ones.
template <class Number, int width>
struct PackOf {
    using MaskNumber = std::conditional_t<sizeof(Number) == 8, long long, int>;
    typedef Number Lanes __attribute__((vector_size(width * sizeof(Number))));
    typedef MaskNumber MaskLanes __attribute__((vector_size(width * sizeof(Number))));
    struct Mask {
        MaskLanes lanes;

        friend WETDECK_INLINE Mask operator|(Mask a, Mask b) { return {a.lanes | b.lanes}; }
    };

    Lanes lanes;

    PackOf() = default;
    WETDECK_INLINE PackOf(Lanes v) : lanes(v) {}
    template <class Value>
    requires std::is_arithmetic_v<Value> WETDECK_INLINE PackOf(Value v)
        : lanes(static_cast<Number>(v) - Lanes{}) {}

    friend WETDECK_INLINE PackOf operator+(PackOf a, PackOf b) { return a.lanes + b.lanes; }
    friend WETDECK_INLINE PackOf operator-(PackOf a, PackOf b) { return a.lanes - b.lanes; }
    friend WETDECK_INLINE PackOf operator-(PackOf a) { return -a.lanes; }
    friend WETDECK_INLINE PackOf operator*(PackOf a, PackOf b) { return a.lanes * b.lanes; }
    friend WETDECK_INLINE PackOf operator/(PackOf a, PackOf b) { return a.lanes / b.lanes; }
    friend WETDECK_INLINE PackOf& operator+=(PackOf& a, PackOf b) { return a = a + b; }
    friend WETDECK_INLINE Mask operator>(PackOf a, PackOf b) { return {a.lanes > b.lanes}; }
    friend WETDECK_INLINE Mask operator<(PackOf a, PackOf b) { return {a.lanes < b.lanes}; }
    friend WETDECK_INLINE PackOf select(Mask m, PackOf a, PackOf b) { return m.lanes ? a.lanes : b.lanes; }
};

using Pack = PackOf<double, pack_width>;

/// Turns a square of eight packs: what was the n-th number of the k-th becomes the k-th of the n-th.
template <class Eight>
WETDECK_INLINE void turn(Eight (&a)[pack_width]) {
    Eight b[pack_width];
    for (int n = 0; n < pack_width; n += 2) {
        b[n] = __builtin_shufflevector(a[n].lanes, a[n + 1].lanes, 0, 8, 2, 10, 4, 12, 6, 14);
        b[n + 1] = __builtin_shufflevector(a[n].lanes, a[n + 1].lanes, 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int n = 0; n < pack_width; ++n) {
        const auto first = b[n & ~2].lanes, second = b[(n & ~2) + 2].lanes;
        a[n] = (n & 2) != 0 ? __builtin_shufflevector(first, second, 2, 3, 10, 11, 6, 7, 14, 15)
                            : __builtin_shufflevector(first, second, 0, 1, 8, 9, 4, 5, 12, 13);
    }
    for (int n = 0; n < pack_width; ++n) {
        const auto first = a[n & ~4].lanes, second = a[(n & ~4) + 4].lanes;
        b[n] = (n & 4) != 0 ? __builtin_shufflevector(first, second, 4, 5, 6, 7, 12, 13, 14, 15)
                            : __builtin_shufflevector(first, second, 0, 1, 2, 3, 8, 9, 10, 11);
    }
    for (int n = 0; n < pack_width; ++n) a[n] = b[n];
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
/// Writes first + n for each n that is marked, and returns how many; it may write eight numbers.
WETDECK_INLINE std::uint32_t write_marked(Pack::Mask mask, std::uint32_t first, std::uint32_t* out) {
    const __mmask8 bits = _mm512_movepi64_mask(__m512i(mask.lanes));
    const __m256i numbers = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(first)),
                                             _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_maskz_compress_epi32(bits, numbers));
    return static_cast<std::uint32_t>(std::popcount(static_cast<unsigned>(bits)));
}
/// rows[k] holds eight numbers; columns[n] receives the n-th of each.
WETDECK_INLINE void transpose(const double* const (&rows)[pack_width], Pack (&columns)[pack_width]) {
    for (int n = 0; n < pack_width; ++n) columns[n] = Pack::Lanes(_mm512_load_pd(rows[n]));
    turn(columns);
}
/// The way back; several rows may be the same place, which then receives the last of them.
WETDECK_INLINE void transpose(const Pack (&columns)[pack_width], double* const (&rows)[pack_width]) {
    Pack turned[pack_width];
    for (int n = 0; n < pack_width; ++n) turned[n] = columns[n];
    turn(turned);
    for (int n = 0; n < pack_width; ++n) _mm512_store_pd(rows[n], __m512d(turned[n].lanes));
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
WETDECK_INLINE std::uint32_t write_marked(Pack::Mask mask, std::uint32_t first, std::uint32_t* out) {
    std::uint32_t count = 0;
    for (int lane = 0; lane < pack_width; ++lane) {
        out[count] = first + static_cast<std::uint32_t>(lane);
        count += mask.lanes[lane] != 0 ? 1 : 0;
    }
    return count;
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

template <class Number, int width>
WETDECK_INLINE PackOf<Number, width> positive_part(PackOf<Number, width> a) {
    return maximum(a, 0.0);
}

}  // namespace wetdeck::WETDECK_ISA
