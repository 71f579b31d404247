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

template <bool graded, class Power>
void update_with(FluidState* state, const DensityUpdate& u, Power power) {
    MixedState* const copies = u.mixed ? u.mixed->data() : nullptr;
    const FixedPoint fixed_point = u.mixed ? u.mixed->fixed_point() : FixedPoint{};
    const auto blocks = static_cast<std::int64_t>((u.last - u.first + cluster_width - 1) / cluster_width);
#pragma omp parallel for schedule(static) num_threads(u.threads)
    for (std::int64_t block = 0; block < blocks; ++block) {
        Cluster eight;
        eight.first = static_cast<std::uint32_t>(u.first) + static_cast<std::uint32_t>(block) * cluster_width;
        eight.count = std::min(cluster_width, static_cast<std::uint32_t>(u.last) - eight.first);
        Pack p[pack_width];
        load_columns(state, eight, p);
        Pack &x = p[0], &y = p[1], &pressure = p[4], &volume = p[5], &density = p[6];
        const Pack vx = p[2], vy = p[3], fineness = p[7];
        const Pack kernel_sum = u.bounds.kernel_sum ? load(u.bounds.kernel_sum, eight) : Pack(1.0);
        Pack open = u.bounds.open;  // of the finest spacing
        if constexpr (graded)
            open = u.eos.reference_density + (u.bounds.open - u.eos.reference_density) / fineness;
        density =
            u.bounds.limit(density + u.dt * load(u.rate, eight), kernel_sum, open, u.eos.reference_density);
        const Pack ratio = density * (1 / u.eos.reference_density);
        pressure = u.eos.coefficient() * (power(ratio) - 1.0) + u.eos.background_pressure;
        volume = load(u.mass, eight) / density;
        x += 0.5 * u.dt * vx;
        y += 0.5 * u.dt * vy;
        store_columns(p, state, eight);
        if (!copies) continue;
        for (std::size_t i = eight.first; i < eight.first + eight.count; ++i)
            copy_row(state[i], fixed_point, copies[i]);
    }
}

}  // namespace

void update_density(FluidState* state, const DensityUpdate& update) {
    const auto with = [&](auto power) {
        update.graded ? update_with<true>(state, update, power) : update_with<false>(state, update, power);
    };
    if (update.eos.exponent == 7) {
        with([](Pack x) { return power_seven(x); });
    } else if (update.eos.exponent == 1.4) {
        with([](Pack x) { return power_seven_fifths(x); });
    } else {
        with([exponent = update.eos.exponent](Pack x) {
            for (int lane = 0; lane < pack_width; ++lane) x.lanes[lane] = std::pow(x.lanes[lane], exponent);
            return x;
        });
    }
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
