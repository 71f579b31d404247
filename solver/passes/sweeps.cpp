// SPDX-License-Identifier: BSD-3-Clause
// Sweeps over particles by themselves: density, pressure and drift at the end of a step; the filter of the
// neighbour list.
#include <limits>

#include "solver/passes/isa_passes.hpp"
#include "solver/passes/simd/mixed_lanes.hpp"

namespace wetdeck::WETDECK_ISA {
namespace {

/// FixedPoint's conversion, all numbers of a state at once.
WETDECK_INLINE void copy_row(const FluidState& from, const FixedPoint& fixed_point, MixedState& to) {
    using Words = PackOf<std::uint32_t, pack_width>::Lanes;
    using LongWords = PackOf<std::uint64_t, pack_width>::Lanes;
    static_assert(sizeof(MixedState) == sizeof(Words) && sizeof(FluidState) == sizeof(Pack));
    Pack row;
    std::memcpy(&row.lanes, &from, sizeof row.lanes);
    const auto numbers = __builtin_convertvector(row.lanes, FloatEight::Lanes);
    const Pack fixed = row * fixed_point.per_metre + FixedPoint::unit_mantissa;
    const Words low = __builtin_convertvector(reinterpret_cast<LongWords>(fixed.lanes), Words);
    const Words all =
        __builtin_shufflevector(low, reinterpret_cast<Words>(numbers), 0, 1, 10, 11, 12, 13, 14, 15);
    std::memcpy(static_cast<void*>(&to), &all, sizeof all);
}

/// ratio^exponent - 1, each branch with its own difference: compilers then fuse it with the last product.
WETDECK_INLINE Pack power_less_one(Pack ratio, double exponent) {
    if (exponent == 7) return power_seven(ratio) - 1.0;
    if (exponent == 1.4) return power_seven_fifths(ratio) - 1.0;
    for (int lane = 0; lane < pack_width; ++lane) ratio.lanes[lane] = std::pow(ratio.lanes[lane], exponent);
    return ratio - 1.0;
}

template <bool graded>
void update_cluster(FluidState* state, const DensityUpdate& u, const Cluster& cluster) {
    const auto& [eos, bounds] = u.groups[cluster.slow ? 0 : 1];
    Pack p[pack_width];
    load_columns(state, cluster, p);
    Pack &x = p[0], &y = p[1], &pressure = p[4], &volume = p[5], &density = p[6];
    const Pack vx = p[2], vy = p[3], fineness = p[7];
    const Pack kernel_sum = bounds.kernel_sum ? load(bounds.kernel_sum, cluster) : Pack(1.0);
    Pack open = bounds.open;  // of the finest spacing
    if constexpr (graded) open = eos.reference_density + (bounds.open - eos.reference_density) / fineness;
    density = bounds.limit(density + u.dt * load(u.rate, cluster), kernel_sum, open, eos.reference_density);
    const Pack ratio = density * (1 / eos.reference_density);
    pressure = eos.coefficient() * power_less_one(ratio, eos.exponent) + eos.background_pressure;
    volume = load(u.mass, cluster) / density;
    const double drift = u.sweep.drift_of(cluster);
    x += drift * vx;
    y += drift * vy;
    store_columns(p, state, cluster);
}

/// Eight candidates.
struct EightCandidates {
    Pack x, y, fineness;
};

/// The candidates from this one on; those beyond the end are infinitely far away.
template <bool graded>
WETDECK_INLINE EightCandidates candidates_from(const Candidates& all, std::uint32_t first) {
    EightCandidates eight;
    const double* const from = all.positions + first * all.stride;
    const bool whole = first + pack_width <= all.end;
    if (whole && all.stride == 2) {
        Pack low, high;
        std::memcpy(&low.lanes, from, sizeof low.lanes);
        std::memcpy(&high.lanes, from + pack_width, sizeof high.lanes);
        eight.x = __builtin_shufflevector(low.lanes, high.lanes, 0, 2, 4, 6, 8, 10, 12, 14);
        eight.y = __builtin_shufflevector(low.lanes, high.lanes, 1, 3, 5, 7, 9, 11, 13, 15);
    } else {
        const std::uint32_t count = whole ? pack_width : all.end - first;
        eight.x = eight.y = std::numeric_limits<double>::infinity();
        for (std::uint32_t n = 0; n < count; ++n) {
            eight.x.lanes[n] = from[n * all.stride];
            eight.y.lanes[n] = from[n * all.stride + 1];
        }
    }
    if constexpr (graded) {
        eight.fineness = 1.0;
        const std::uint32_t count = whole ? pack_width : all.end - first;
        for (std::uint32_t n = 0; n < count; ++n)
            eight.fineness.lanes[n] = all.fineness[(first + n) * all.fineness_stride];
    }
    return eight;
}

}  // namespace

void update_density(FluidState* state, const DensityUpdate& update) {
    MixedState* const copies = update.mixed ? update.mixed->data() : nullptr;
    const FixedPoint fixed_point = update.mixed ? update.mixed->fixed_point() : FixedPoint{};
    update.clusters.for_each([&](const Cluster& cluster, int) {
        if (update.sweep.leaves_out(cluster)) return;
        update.graded ? update_cluster<true>(state, update, cluster)
                      : update_cluster<false>(state, update, cluster);
        if (!copies) return;
        for (std::size_t i = cluster.first; i < cluster.first + cluster.count; ++i)
            copy_row(state[i], fixed_point, copies[i]);
    });
}

template <bool graded>
std::uint32_t filter_near(const ClusterPoints& points, const Candidates& candidates, const ListReach& reach,
                          std::uint32_t* out) {
    // locals: `out` might write to the numbers of the candidates
    const Candidates all = candidates;
    const ListReach limits = reach;
    const Pack farthest2 = limits.of(1.0) * limits.of(1.0);
    std::uint32_t found = 0;
    for (std::uint32_t first = all.begin; first < all.end; first += pack_width) {
        const EightCandidates at = candidates_from<graded>(all, first);
        Pack::Mask near{};
        Pack nearest2 = std::numeric_limits<double>::infinity();
        for (int lane = 0; lane < pack_width; ++lane) {
            const Pack x = points.x[lane] - at.x, y = points.y[lane] - at.y;
            const Pack distance2 = x * x + y * y;
            if constexpr (graded) {
                const Pack farthest = limits.of(points.half_fineness[lane] + 0.5 * at.fineness);
                near = near | (distance2 < farthest * farthest);
            } else {
                nearest2 = minimum(nearest2, distance2);
            }
        }
        if constexpr (!graded) near = nearest2 < farthest2;
        found += write_marked(near, first, out + found);
    }
    return found;
}

template std::uint32_t filter_near<false>(const ClusterPoints&, const Candidates&, const ListReach&,
                                          std::uint32_t*);
template std::uint32_t filter_near<true>(const ClusterPoints&, const Candidates&, const ListReach&,
                                         std::uint32_t*);

}  // namespace wetdeck::WETDECK_ISA
