// SPDX-License-Identifier: BSD-3-Clause
// The pair loops themselves. Compiled once per instruction set, with WETDECK_ISA naming the namespace.
#include <algorithm>

#include "solver/passes/instruction_sets.hpp"
#include "solver/passes/simd/lanes.hpp"
#include "solver/passes/wall_pairs.hpp"
#include "solver/physics/riemann.hpp"

namespace wetdeck::WETDECK_ISA {
namespace {

/// Calls `work` for each cluster. A thread takes one share: neighbours in space stay with it from pass to
/// pass.
template <class Work>
void for_clusters(const PassInput& in, Work work) {
    const auto shares = static_cast<std::int64_t>(in.shares->size()) - 1;
#pragma omp parallel for schedule(static) num_threads(in.threads)
    for (std::int64_t n = 0; n < shares; ++n) {
        const auto share = static_cast<std::size_t>(n);
        for (std::size_t k = (*in.shares)[share]; k < (*in.shares)[share + 1]; ++k) work((*in.clusters)[k]);
    }
}

/// How often what this cluster gets without air counts: from water, walls and gravity. Pairs with air count
/// once.
double own_weight(const PassInput& in, const Cluster& cluster) {
    return cluster.phase == Phase::water ? in.water_weight : 1;
}

/// Whether a pass has nothing to add up for this cluster: water that no air is near, between steps of the
/// water.
bool rests(const PassInput& in, const Cluster& cluster) {
    return cluster.phase == Phase::water && in.water_weight == 0 && cluster.fluid_neighbours[1] == 0;
}

// --- continuity: d(rho_i)/dt = 2 rho_i SUM_j V_j F (u_L - u*), Eq. (12)

struct DensitySums {
    Pack rate = 0.0, cover = 0.0;
};

template <bool harmonic, bool hydrostatic, bool covered>
WETDECK_INLINE void density_sum(const PassInput& in, const Lanes& i, const std::uint32_t* neighbours,
                                std::uint32_t count, const PairCoefficients& c, Pack mobility, double times,
                                DensitySums& sums) {
    const double inverse_h = 1 / in.kernel.smoothing_length;
    const double gx = c.hydrostatic_density * in.gravity.x(), gy = c.hydrostatic_density * in.gravity.y();
    Pack sum = 0.0, cover = 0.0;
    for (std::uint32_t n = 0; n < count; ++n) {
        const FluidState& j = in.fluid[neighbours[n]];
        const Separation s = separation(i, j.x, j.y);
        Pack jump = i.pressure - j.pressure;
        if constexpr (hydrostatic) jump = jump - (gx * s.x + gy * s.y);
        // F (u_L - u*) with F = r W', so that nothing is divided by r: r u = -v . r_ij
        Pack deficit;
        if constexpr (harmonic) {
            const Pack u_left = -(i.vx * s.x + i.vy * s.y) * s.inverse_distance;
            const Pack u_right = -(j.vx * s.x + j.vy * s.y) * s.inverse_distance;
            const Pack u_mean = guarded_harmonic_mean(u_left, u_right, in.velocity_guard);
            deficit = s.distance * (u_left - u_mean - mobility * jump);
        } else {
            const Pack closing = (j.vx - i.vx) * s.x + (j.vy - i.vy) * s.y;
            deficit = velocity_deficit(closing, jump * s.distance, c.weight_right, mobility);
        }
        sum += j.volume * WendlandC2::cubed_reach(s.distance, inverse_h) * deficit;
        if constexpr (covered) cover += j.volume * WendlandC2::bell(s.distance, inverse_h);
    }
    sums.rate += times * sum;
    if constexpr (covered) sums.cover += cover;
}

/// Free slip and no slip alike: the wall reverses the normal velocity about its own and has no pressure jump;
/// an edge of a body, which has no normal, reverses the whole velocity. Where the wall is mirrored it moves
/// along its face with the water around it.
template <bool mirrored, bool covered>
void wall_density_sum(const PassInput& in, const Lanes& i, const std::uint32_t* neighbours,
                      std::uint32_t count, double times, DensitySums& sums) {
    const double inverse_h = 1 / in.kernel.smoothing_length;
    Pack sum = 0.0, stretching = 0.0, cover = 0.0;
    // Height of the particle above the layer of the nearest boundary particle, which tells its own face: the
    // other face of a thin body, or of an edge, has no say.
    Pack closest = in.kernel.support_radius(), nearest = in.kernel.smoothing_length;
    for (std::uint32_t n = 0; n < count; ++n) {
        const WallState& w = in.wall[neighbours[n]];
        const Separation s = separation(i, w.x, w.y);
        const Pack weight = WendlandC2::cubed_reach(s.distance, inverse_h);
        if constexpr (covered) cover += WendlandC2::bell(s.distance, inverse_h);
        const bool edge = w.nx == 0 && w.ny == 0;
        const Pack height = edge ? s.distance : s.x * w.nx + s.y * w.ny;
        if constexpr (mirrored || covered) {
            nearest = select(s.distance < closest, height, nearest);
            closest = minimum(closest, s.distance);
        }
        if (edge) {
            sum = sum - weight * ((i.vx - w.vx) * s.x + (i.vy - w.vy) * s.y);
        } else {
            const Pack closing = -((i.vx - w.vx) * w.nx + (i.vy - w.vy) * w.ny);
            sum += weight * closing * height;
            if constexpr (mirrored) {
                const WallMean& mean = in.wall_mean[neighbours[n]];
                const Pack slip = (i.vy - mean.vy) * w.nx - (i.vx - mean.vx) * w.ny;
                const Pack along = s.y * w.nx - s.x * w.ny;
                stretching += select(height > 0.0, weight * slip * along, 0.0);
            }
        }
    }
    const Pack distance = nearest * (1 / in.particle_spacing) - 0.5;  // from the face, in spacings
    if constexpr (mirrored) sum = sum - 0.5 * stretching_share(distance) * stretching;
    sums.rate += times * in.wall_volume * sum;
    if constexpr (covered) {
        const double inverse_norm = 1 / in.kernel.normalisation();
        const Pack touching = inverse_norm * (touching_cover + positive_part(-distance));
        sums.cover = select(distance < touching_distance, touching, sums.cover + in.wall_volume * cover);
    }
}

template <bool harmonic, bool hydrostatic, bool mirrored, bool covered>
WETDECK_INLINE void cluster_density_rates(const PassInput& in, const Cluster& cluster) {
    if (rests(in, cluster)) return store(0.0, in.density_rate, cluster);
    const Lanes i = load(in.fluid, cluster);
    const auto& coefficients = in.pair[static_cast<std::size_t>(cluster.phase)];
    const std::uint32_t* neighbours = cluster.neighbours;
    const Pack thinner = in.reference_density[static_cast<std::size_t>(cluster.phase)] / i.density;
    const double own = own_weight(in, cluster);
    DensitySums sums;
    for (std::size_t phase = 0; phase < phase_count; ++phase) {
        const std::uint32_t count = cluster.fluid_neighbours[phase];
        const PairCoefficients& c = coefficients[phase];
        const double times = phase == 1 ? 1 : own;
        if (times > 0)
            density_sum<harmonic, hydrostatic, covered>(in, i, neighbours, count, c, c.mobility * thinner,
                                                        times, sums);
        neighbours += count;
    }
    if (cluster.wall_neighbours > 0 && own > 0)
        wall_density_sum<mirrored, covered>(in, i, neighbours, cluster.wall_neighbours, own, sums);
    store(2 * in.kernel.slope_factor() * i.density * sums.rate, in.density_rate, cluster);
    if constexpr (covered) store(in.kernel.normalisation() * sums.cover, in.cover, cluster);
}

template <bool harmonic, bool hydrostatic, bool mirrored>
void density_rates(const PassInput& in) {
    for_clusters(in, [&in](const Cluster& cluster) {
        if (cluster.phase == Phase::air) {
            cluster_density_rates<harmonic, hydrostatic, false, false>(in, cluster);
        } else if (in.cover) {
            cluster_density_rates<harmonic, hydrostatic, mirrored, true>(in, cluster);
        } else {
            cluster_density_rates<harmonic, hydrostatic, mirrored, false>(in, cluster);
        }
    });
}

// --- momentum: dv_i/dt = (2/rho_i) SUM_j V_j P* F r_ij / r + g, Eq. (12)

template <bool harmonic, bool dissipative, bool viscous, bool switched>
WETDECK_INLINE void momentum_sum(const PassInput& in, const Lanes& i, const std::uint32_t* neighbours,
                                 std::uint32_t count, const PairCoefficients& c, double times,
                                 VectorSum& sum) {
    const double inverse_h = 1 / in.kernel.smoothing_length;
    VectorSum fluid;
    for (std::uint32_t n = 0; n < count; ++n) {
        const FluidState& j = in.fluid[neighbours[n]];
        const Separation s = separation(i, j.x, j.y);
        Pack p_star;
        if constexpr (harmonic) {
            p_star = guarded_harmonic_mean(i.pressure, Pack(j.pressure), in.pressure_guard);
        } else {
            p_star = weighted_pressure(i.pressure, Pack(j.pressure), c.pressure_weight_left,
                                       c.pressure_weight_right);
        }
        if constexpr (dissipative || viscous || switched) {
            const Pack jump = ((j.vx - i.vx) * s.x + (j.vy - i.vy) * s.y) * s.inverse_distance;
            if constexpr (dissipative) p_star += riemann_dissipation(jump, c.limiter);
            if constexpr (viscous) p_star += c.viscosity * maximum(jump, c.lowest_viscous_jump);
            if constexpr (switched) {
                const Pack u_mean = -0.5 * ((j.vx + i.vx) * s.x + (j.vy + i.vy) * s.y) * s.inverse_distance;
                const Pack on = maximum(i.impact, j.impact);
                p_star += on * c.half_density * maximum(u_mean, -u_mean) * jump;
            }
        }
        const Pack weight = j.volume * WendlandC2::cubed_reach(s.distance, inverse_h) * p_star;
        fluid.x += weight * s.x;
        fluid.y += weight * s.y;
    }
    sum.x += times * fluid.x;
    sum.y += times * fluid.y;
}

template <bool no_slip, bool shepard>
void wall_momentum_sum(const PassInput& in, const Lanes& i, const std::uint32_t* neighbours,
                       std::uint32_t count, const WallCoefficients& c, double times, VectorSum& sum) {
    const double inverse_h = 1 / in.kernel.smoothing_length;
    VectorSum wall;
    for (std::uint32_t n = 0; n < count; ++n) {
        const WallState& w = in.wall[neighbours[n]];
        const Separation s = separation(i, w.x, w.y);
        const double mean = shepard ? in.wall_mean[neighbours[n]].pressure : 0;
        const Pack p_star = wall_p_star<no_slip, shepard>(
            i.pressure, i.density, s.x, s.y, i.vx - w.vx, i.vy - w.vy, s.inverse_distance, w.nx, w.ny,
            w.ax - in.gravity.x(), w.ay - in.gravity.y(), mean, c);
        const Pack weight = WendlandC2::cubed_reach(s.distance, inverse_h) * p_star;
        wall.x += weight * s.x;
        wall.y += weight * s.y;
    }
    sum.x += times * in.wall_volume * wall.x;
    sum.y += times * in.wall_volume * wall.y;
}

template <bool harmonic, bool dissipative, bool viscous, bool switched, bool no_slip>
void accelerations(const PassInput& in) {
    for_clusters(in, [&in](const Cluster& cluster) {
        if (rests(in, cluster)) {
            store(0.0, in.acceleration_x, cluster);
            return store(0.0, in.acceleration_y, cluster);
        }
        const auto phase_i = static_cast<std::size_t>(cluster.phase);
        const Lanes i = load(in.fluid, cluster);
        const std::uint32_t* neighbours = cluster.neighbours;
        const double own = own_weight(in, cluster);
        VectorSum sum;
        for (std::size_t phase = 0; phase < phase_count; ++phase) {
            const std::uint32_t count = cluster.fluid_neighbours[phase];
            const double times = phase == 1 ? 1 : own;
            if (times > 0)
                momentum_sum<harmonic, dissipative, viscous, switched>(in, i, neighbours, count,
                                                                       in.pair[phase_i][phase], times, sum);
            neighbours += count;
        }
        if (cluster.wall_neighbours > 0 && own > 0) {
            const bool shepard = in.wall_pressure_mean[phase_i];
            const auto wall_sum =
                shepard ? wall_momentum_sum<no_slip, true> : wall_momentum_sum<no_slip, false>;
            wall_sum(in, i, neighbours, cluster.wall_neighbours, in.wall_pair[phase_i], own, sum);
        }
        const Pack factor = 2 * in.kernel.slope_factor() / i.density;
        store(factor * sum.x + own * in.gravity.x(), in.acceleration_x, cluster);
        store(factor * sum.y + own * in.gravity.y(), in.acceleration_y, cluster);
    });
}

// --- density and equation of state

template <class Power>
void advance_phase(FluidState* state, const double* rate, const double* mass, std::size_t first,
                   std::size_t last, double dt, const TaitEquationOfState& eos, const DensityBounds& bounds,
                   int threads, Power power) {
    const auto blocks = static_cast<std::int64_t>((last - first + cluster_width - 1) / cluster_width);
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t block = 0; block < blocks; ++block) {
        Cluster eight;
        eight.first = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(block) * cluster_width;
        eight.count = std::min(cluster_width, static_cast<std::uint32_t>(last) - eight.first);
        Pack p[pack_width];
        load_columns(state, eight, p);
        Pack &x = p[0], &y = p[1], &pressure = p[4], &volume = p[5], &density = p[6];
        const Pack vx = p[2], vy = p[3], cover = bounds.cover ? load(bounds.cover, eight) : Pack(1.0);
        density = bounds.limit(density + dt * load(rate, eight), cover, eos.reference_density);
        const Pack ratio = density * (1 / eos.reference_density);
        pressure = eos.coefficient() * (power(ratio) - 1.0) + eos.background_pressure;
        volume = load(mass, eight) / density;
        x += 0.5 * dt * vx;
        y += 0.5 * dt * vy;
        store_columns(p, state, eight);
    }
}

void advance_fluid(FluidState* state, const double* rate, const double* mass, std::size_t first,
                   std::size_t last, double dt, const TaitEquationOfState& eos, const DensityBounds& bounds,
                   int threads) {
    const auto advance = [&](auto power) {
        advance_phase(state, rate, mass, first, last, dt, eos, bounds, threads, power);
    };
    if (eos.exponent == 7) {
        advance([](Pack x) { return power_seven(x); });
    } else if (eos.exponent == 1.4) {
        advance([](Pack x) { return power_seven_fifths(x); });
    } else {
        advance([&eos](Pack x) {
            for (int lane = 0; lane < pack_width; ++lane)
                x.lanes[lane] = std::pow(x.lanes[lane], eos.exponent);
            return x;
        });
    }
}

// --- neighbour list

std::uint32_t filter_near(const ClusterPoints& points, const double* candidates, std::size_t stride,
                          std::uint32_t begin, std::uint32_t end, double reach, std::uint32_t* out) {
    Pack px, py;
    std::memcpy(&px.lanes, points.x, sizeof px.lanes);
    std::memcpy(&py.lanes, points.y, sizeof py.lanes);
    const Pack reach2 = reach * reach;
    std::uint32_t found = 0;
    for (std::uint32_t candidate = begin; candidate < end; ++candidate) {
        const double* position = candidates + candidate * stride;
        const Pack x = px - position[0];
        const Pack y = py - position[1];
        out[found] = candidate;
        found += any(x * x + y * y < reach2) ? 1 : 0;
    }
    return found;
}

// --- choice of the passes, once per run

/// Calls f with one std::bool_constant per flag: run-time choices become template arguments.
template <class F>
auto with_flags(F f) {
    return f();
}
template <class F, class... Rest>
auto with_flags(F f, bool flag, Rest... rest) {
    return flag ? with_flags([f](auto... more) { return f(std::true_type{}, more...); }, rest...)
                : with_flags([f](auto... more) { return f(std::false_type{}, more...); }, rest...);
}

}  // namespace

PairLoops choose_pair_loops(const Model& model) {
    PairLoops loops;
    loops.wall_means = wall_means;
    loops.density_rates =
        with_flags([](auto harmonic, auto hydrostatic,
                      auto mirrored) -> Pass { return density_rates<harmonic, hydrostatic, mirrored>; },
                   model.velocity_mean == Mean::harmonic, model.hydrostatic_correction,
                   model.wall_velocity == WallVelocity::mirrored);
    loops.accelerations = with_flags(
        [](auto harmonic, auto dissipative, auto viscous, auto switched, auto no_slip) -> Pass {
            return accelerations<harmonic, dissipative, viscous, switched, no_slip>;
        },
        model.pressure_mean == Mean::harmonic, model.dissipation != Dissipation::none,
        model.viscosity != Viscosity::none, model.dissipation_switch, model.wall_slip == WallSlip::no);
    loops.body_forces = body_force_pass(model);
    loops.advance_fluid = advance_fluid;
    loops.filter_near = filter_near;
    return loops;
}

}  // namespace wetdeck::WETDECK_ISA
