// SPDX-License-Identifier: BSD-3-Clause
// Pairs of fluid particles in mixed precision: the same members as InDouble, for numbers in single precision.
//
// With AVX-512 sixteen lanes hold the eight particles of a cluster twice and take two neighbours at a time;
// the two halves of a sum are added in double precision. Elsewhere eight lanes take one neighbour at a time.
#pragma once

#include "solver/passes/simd/lanes.hpp"

namespace wetdeck::WETDECK_ISA {

#if defined(WETDECK_AVX512)
inline constexpr int neighbours_at_once = 2;
#else
inline constexpr int neighbours_at_once = 1;
#endif

using FloatPack = PackOf<float, pack_width * neighbours_at_once>;
using FloatEight = PackOf<float, pack_width>;
using FixedPack = PackOf<std::uint32_t, pack_width * neighbours_at_once>;

#if defined(WETDECK_AVX512)
WETDECK_INLINE FloatPack maximum(FloatPack a, FloatPack b) {
    return FloatPack::Lanes(_mm512_max_ps(__m512(a.lanes), __m512(b.lanes)));
}
WETDECK_INLINE FloatPack minimum(FloatPack a, FloatPack b) {
    return FloatPack::Lanes(_mm512_min_ps(__m512(a.lanes), __m512(b.lanes)));
}
/// As for doubles, with one term of the series.
WETDECK_INLINE void square_roots(FloatPack x, FloatPack& root, FloatPack& inverse_root) {
    const FloatPack estimate = FloatPack::Lanes(_mm512_rsqrt14_ps(__m512(x.lanes)));
    const FloatPack product = x * estimate;
    const FloatPack correction = 0.5 * (1.0 - product * estimate);
    root = product + product * correction;
    inverse_root = estimate + estimate * correction;
}
/// The same eight numbers in both halves.
WETDECK_INLINE FloatPack for_all_neighbours(FloatEight a) {
    return __builtin_shufflevector(a.lanes, a.lanes, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7);
}
WETDECK_INLINE Pack first_half(FloatPack a) {
    return Pack::Lanes(_mm512_cvtps_pd(_mm512_castps512_ps256(__m512(a.lanes))));
}
WETDECK_INLINE Pack sum_of_halves(FloatPack a) {
    return first_half(a) + Pack::Lanes(_mm512_cvtps_pd(_mm512_extractf32x8_ps(__m512(a.lanes), 1)));
}
#else
WETDECK_INLINE FloatPack maximum(FloatPack a, FloatPack b) {
    return a.lanes > b.lanes ? a.lanes : b.lanes;
}
WETDECK_INLINE FloatPack minimum(FloatPack a, FloatPack b) {
    return a.lanes < b.lanes ? a.lanes : b.lanes;
}
WETDECK_INLINE void square_roots(FloatPack x, FloatPack& root, FloatPack& inverse_root) {
    for (int lane = 0; lane < pack_width; ++lane) root.lanes[lane] = std::sqrt(x.lanes[lane]);
    inverse_root = 1.0 / root;
}
WETDECK_INLINE FloatPack for_all_neighbours(FloatEight a) {
    return a;
}
WETDECK_INLINE Pack first_half(FloatPack a) {
    return __builtin_convertvector(a.lanes, Pack::Lanes);
}
WETDECK_INLINE Pack sum_of_halves(FloatPack a) {
    return first_half(a);
}
#endif

/// A cluster in single precision.
struct MixedLanes {
    FixedPack x, y;
    FloatPack vx, vy, pressure, density, fineness;
};

WETDECK_INLINE FixedPack bits_of(FloatEight a) {
    const FloatPack all = for_all_neighbours(a);
    FixedPack fixed;
    std::memcpy(&fixed.lanes, &all.lanes, sizeof fixed.lanes);
    return fixed;
}

/// In units of positions, which the sums are brought to metres from.
WETDECK_INLINE SeparationOf<FloatPack> separation(const MixedLanes& i, FixedPack x, FixedPack y) {
    constexpr float least_squared_distance = 1e-12F;
    const auto units = [](FixedPack difference) -> FloatPack {
        using Signed = FloatPack::MaskLanes;
        return __builtin_convertvector(reinterpret_cast<Signed>(difference.lanes), FloatPack::Lanes);
    };
    SeparationOf<FloatPack> s;
    s.x = units(i.x - x);
    s.y = units(i.y - y);
    square_roots(s.x * s.x + (s.y * s.y + least_squared_distance), s.distance, s.inverse_distance);
    return s;
}

/// Two neighbours, one in each half of the lanes.
struct MixedPair {
    FixedPack x, y;
    FloatPack vx, vy, pressure, volume, density, fineness;
};

#if defined(WETDECK_AVX512)
WETDECK_INLINE FloatPack halves(const float& first, const float& second) {
    constexpr __mmask16 upper = 0xFF00;
    return FloatPack::Lanes(_mm512_mask_broadcastss_ps(_mm512_set1_ps(first), upper, _mm_load_ss(&second)));
}
WETDECK_INLINE FixedPack halves(const std::uint32_t& first, const std::uint32_t& second) {
    constexpr __mmask16 upper = 0xFF00;
    return FixedPack::Lanes(_mm512_mask_broadcastd_epi32(_mm512_set1_epi32(static_cast<int>(first)), upper,
                                                         _mm_loadu_si32(&second)));
}

/// Neighbours two by two. Nowhere stands in for the last where their number is odd.
struct TwoByTwo {
    struct Iterator {
        const MixedState* states;
        const MixedState* nowhere;
        const std::uint32_t* index;
        const std::uint32_t* last;

        WETDECK_INLINE MixedPair operator*() const {
            const MixedState& a = states[*index];
            const MixedState& b = index < last ? states[index[1]] : *nowhere;
            return {halves(a.x, b.x),
                    halves(a.y, b.y),
                    halves(a.vx, b.vx),
                    halves(a.vy, b.vy),
                    halves(a.pressure, b.pressure),
                    halves(a.volume, b.volume),
                    halves(a.density, b.density),
                    halves(a.fineness, b.fineness)};
        }
        WETDECK_INLINE void operator++() { index += 2; }
        WETDECK_INLINE bool operator!=(const std::uint32_t* end) const { return index < end; }
    };
    const MixedFluid& fluid;
    Neighbours neighbours;

    WETDECK_INLINE const std::uint32_t* end() const { return neighbours.data() + neighbours.size(); }
    WETDECK_INLINE Iterator begin() const {
        return {fluid.data(), &fluid.nowhere(), neighbours.data(), end() - 1};
    }
};
#endif

struct InMixed {
    using Number = FloatPack;
    using Fluid = MixedLanes;
    static WETDECK_INLINE Fluid load(const PassInput& in, const Cluster& cluster) {
        static_assert(sizeof(MixedState) == sizeof(FloatEight));
        FloatEight c[pack_width];
        for (std::uint32_t lane = 0; lane < cluster_width; ++lane)
            std::memcpy(&c[lane].lanes, &in.mixed->data()[cluster.at(lane)], sizeof c[lane].lanes);
        turn(c);
        return {bits_of(c[0]),
                bits_of(c[1]),
                for_all_neighbours(c[2]),
                for_all_neighbours(c[3]),
                for_all_neighbours(c[4]),
                for_all_neighbours(c[6]),
                for_all_neighbours(c[7])};
    }
    static WETDECK_INLINE Lanes beside_walls(const PassInput& in, const Cluster& cluster, const Fluid&) {
        return WETDECK_ISA::load(in.fluid, cluster);
    }
#if defined(WETDECK_AVX512)
    static WETDECK_INLINE TwoByTwo each(const PassInput& in, Neighbours neighbours) {
        return {*in.mixed, neighbours};
    }
#else
    static WETDECK_INLINE OneByOne<MixedState> each(const PassInput& in, Neighbours neighbours) {
        return {in.mixed->data(), neighbours};
    }
#endif
    static WETDECK_INLINE double unit_of_length(const PassInput& in) {
        return 1 / in.mixed->fixed_point().per_metre;
    }
    static WETDECK_INLINE Pack total(Number sum) {
        return sum_of_halves(sum);
    }
    static WETDECK_INLINE Pack of_cluster(Number number) {
        return first_half(number);
    }
};

}  // namespace wetdeck::WETDECK_ISA
