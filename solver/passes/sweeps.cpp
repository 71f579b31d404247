// SPDX-License-Identifier: BSD-3-Clause
// Sweeps over particles by themselves: density, pressure and drift at the end of a step; the filter of the
// neighbour list.
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
    Pack px, py;
    std::memcpy(&px.lanes, points.x, sizeof px.lanes);
    std::memcpy(&py.lanes, points.y, sizeof py.lanes);
    Pack half_fineness;
    std::memcpy(&half_fineness.lanes, points.half_fineness, sizeof half_fineness.lanes);
    Pack farthest = reach.of(1.0);
    const ListReach limits = reach;
    const double* position = candidates.positions + candidates.begin * candidates.stride;
    const double* fineness = candidates.fineness + candidates.begin * candidates.fineness_stride;
    // locals: `out` might write to the numbers of the candidates
    const std::size_t stride = candidates.stride, fineness_stride = candidates.fineness_stride;
    const std::uint32_t end = candidates.end;
    std::uint32_t found = 0;
    for (std::uint32_t candidate = candidates.begin; candidate < end; ++candidate, position += stride) {
        const Pack x = px - position[0];
        const Pack y = py - position[1];
        if constexpr (graded) {
            farthest = limits.of(half_fineness + 0.5 * *fineness);
            fineness += fineness_stride;
        }
        out[found] = candidate;
        found += any_less(x * x + y * y, farthest * farthest) ? 1 : 0;
    }
    return found;
}

template std::uint32_t filter_near<false>(const ClusterPoints&, const Candidates&, const ListReach&,
                                          std::uint32_t*);
template std::uint32_t filter_near<true>(const ClusterPoints&, const Candidates&, const ListReach&,
                                         std::uint32_t*);

}  // namespace wetdeck::WETDECK_ISA
