// SPDX-License-Identifier: BSD-3-Clause
// Eight doubles that are computed on together. Included only by the translation units of the pair loop, which
// are compiled once per instruction set: WETDECK_ISA names the namespace, so that no symbol of one set is
// linked into another.
#pragma once

#include <immintrin.h>

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

#if defined(__AVX512F__)
WETDECK_INLINE Pack maximum(Pack a, Pack b) {
    return Pack::Lanes(_mm512_max_pd(__m512d(a.lanes), __m512d(b.lanes)));
}
WETDECK_INLINE Pack minimum(Pack a, Pack b) {
    return Pack::Lanes(_mm512_min_pd(__m512d(a.lanes), __m512d(b.lanes)));
}
/// 1/sqrt(x) for x > 0: the 14-bit estimate and two Newton steps.
WETDECK_INLINE Pack inverse_sqrt(Pack x) {
    Pack y = Pack::Lanes(_mm512_rsqrt14_pd(__m512d(x.lanes)));
    const Pack half = 0.5 * x;
    y = y * (1.5 - half * y * y);
    return y * (1.5 - half * y * y);
}
#else
WETDECK_INLINE Pack maximum(Pack a, Pack b) {
    return a.lanes > b.lanes ? a.lanes : b.lanes;
}
WETDECK_INLINE Pack minimum(Pack a, Pack b) {
    return a.lanes < b.lanes ? a.lanes : b.lanes;
}
WETDECK_INLINE Pack inverse_sqrt(Pack x) {
    Pack root;
    for (int lane = 0; lane < pack_width; ++lane) root.lanes[lane] = std::sqrt(x.lanes[lane]);
    return 1.0 / root;
}
#endif

WETDECK_INLINE bool any(Pack::Mask m) {
    long long bits = 0;
    for (int lane = 0; lane < pack_width; ++lane) bits |= m.lanes[lane];
    return bits != 0;
}

WETDECK_INLINE Pack positive_part(Pack a) {
    return maximum(a, 0.0);
}

}  // namespace wetdeck::WETDECK_ISA
