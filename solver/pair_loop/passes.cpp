// SPDX-License-Identifier: BSD-3-Clause
// The pair loops themselves. Compiled once per instruction set, with WETDECK_ISA naming the namespace.
#include <algorithm>

#include "solver/pair_loop/instruction_sets.hpp"
#include "solver/pair_loop/pack.hpp"
#include "solver/pair_loop/pair_loop.hpp"
#include "solver/physics/riemann.hpp"

namespace wetdeck::WETDECK_ISA {
namespace {

/// The particles of a cluster, one per lane. Lanes beyond its count hold particles that are computed and not
/// stored.
struct Lanes {
    Pack x, y, vx, vy, pressure, density, impact;
};

WETDECK_INLINE Lanes load(const FluidState* state, std::uint32_t first, std::uint32_t count) {
    Lanes lanes;
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) {
        const FluidState& particle = state[first + std::min(lane, count - 1)];
        lanes.x.lanes[lane] = particle.x;
        lanes.y.lanes[lane] = particle.y;
        lanes.vx.lanes[lane] = particle.vx;
        lanes.vy.lanes[lane] = particle.vy;
        lanes.pressure.lanes[lane] = particle.pressure;
        lanes.density.lanes[lane] = particle.density;
        lanes.impact.lanes[lane] = particle.impact;
    }
    return lanes;
}

WETDECK_INLINE void store(Pack values, double* out, const Cluster& cluster) {
    for (std::uint32_t lane = 0; lane < cluster.count; ++lane) out[cluster.first + lane] = values.lanes[lane];
}

/// Geometry of the pairs of a cluster with one neighbour; e points from i to j, e = -(dx, dy) / r.
struct Separation {
    Pack x, y, distance, inverse_distance;
};

/// A particle meets itself in its own list; the smallest distance keeps 1/r finite there, where all else is
/// zero.
template <class Eight>
WETDECK_INLINE Separation separation(const Eight& i, double x, double y) {
    constexpr double least_squared_distance = 1e-60;
    Separation s;
    s.x = i.x - x;
    s.y = i.y - y;
    const Pack squared = s.x * s.x + (s.y * s.y + least_squared_distance);
    s.inverse_distance = inverse_sqrt(squared);
    s.distance = squared * s.inverse_distance;
    return s;
}

// --- continuity: d(rho_i)/dt = 2 rho_i SUM_j V_j F (u_L - u*), Eq. (12)
// -----------------------------------------------

template <bool harmonic, bool hydrostatic>
WETDECK_INLINE Pack density_sum(const PassInput& in, const Lanes& i, const std::uint32_t* neighbours,
                                std::uint32_t count, const PairCoefficients& c) {
    const double inverse_h = 1 / in.kernel.smoothing_length;
    const double gx = c.hydrostatic_density * in.gravity.x(), gy = c.hydrostatic_density * in.gravity.y();
    Pack sum = 0.0;
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
            deficit = s.distance * (u_left - u_mean - c.mobility * jump);
        } else {
            const Pack closing = (j.vx - i.vx) * s.x + (j.vy - i.vy) * s.y;
            deficit = velocity_deficit(closing, jump * s.distance, c.weight_right, c.mobility);
        }
        sum += j.volume * WendlandC2::cubed_reach(s.distance, inverse_h) * deficit;
    }
    return sum;
}

/// Free slip and no slip alike: the wall reverses the normal velocity about its own and has no pressure jump.
/// Where it is mirrored it moves along its face with the water around it.
template <bool mirrored>
Pack wall_density_sum(const PassInput& in, const Lanes& i, const std::uint32_t* neighbours,
                      std::uint32_t count) {
    const double inverse_h = 1 / in.kernel.smoothing_length;
    Pack sum = 0.0, stretching = 0.0;
    Pack nearest =
        1 / inverse_h;  // height above the first layer of dummy particles, half a spacing behind the face
    for (std::uint32_t n = 0; n < count; ++n) {
        const WallState& w = in.wall[neighbours[n]];
        const Separation s = separation(i, w.x, w.y);
        const Pack closing = -((i.vx - w.vx) * w.nx + (i.vy - w.vy) * w.ny);
        const Pack height = s.x * w.nx + s.y * w.ny;
        const Pack weight = WendlandC2::cubed_reach(s.distance, inverse_h);
        sum += weight * closing * height;
        if constexpr (mirrored) {
            const WallMean& mean = in.wall_mean[neighbours[n]];
            const Pack slip = (i.vy - mean.vy) * w.nx - (i.vx - mean.vx) * w.ny;
            const Pack along = s.y * w.nx - s.x * w.ny;
            stretching += select(height > 0.0, weight * slip * along, 0.0);
            // only what lies beneath the particle is near, not the side of an edge that it passes
            nearest = select(height * height < along * along, nearest, minimum(nearest, height));
        }
    }
    if constexpr (mirrored) {
        const Pack distance = nearest * (1 / in.particle_spacing) - 0.5;
        sum = sum - 0.5 * stretching_share(distance) * stretching;
    }
    return in.wall_volume * sum;
}

template <bool harmonic, bool hydrostatic, bool mirrored>
void density_rates(const PassInput& in) {
    const auto cluster_count = static_cast<std::int64_t>(in.clusters->size());
#pragma omp parallel for schedule(static) num_threads(in.threads)
    for (std::int64_t n = 0; n < cluster_count; ++n) {
        const Cluster& cluster = (*in.clusters)[static_cast<std::size_t>(n)];
        const Lanes i = load(in.fluid, cluster.first, cluster.count);
        const auto& coefficients = in.pair[static_cast<std::size_t>(cluster.phase)];
        const std::uint32_t* neighbours = cluster.neighbours;
        Pack sum = 0.0;
        for (std::size_t phase = 0; phase < phase_count; ++phase) {
            const std::uint32_t count = cluster.fluid_neighbours[phase];
            sum += density_sum<harmonic, hydrostatic>(in, i, neighbours, count, coefficients[phase]);
            neighbours += count;
        }
        const bool along = mirrored && cluster.phase == Phase::water;
        const auto wall_sum = along ? wall_density_sum<true> : wall_density_sum<false>;
        sum += wall_sum(in, i, neighbours, cluster.wall_neighbours);
        store(2 * in.kernel.slope_factor() * i.density * sum, in.density_rate, cluster);
    }
}

// --- walls: P_w = SUM_f [ P_f + rho_f (a_w - g) . (r_f - r_w) ] W_wf / SUM_f W_wf, Eq. (19)
// -------------------------

/// Eight boundary particles.
struct WallLanes {
    Pack x, y, vx, vy, nx, ny, drive_x, drive_y;  ///< drive: acceleration less gravity
};

WETDECK_INLINE WallLanes load(const PassInput& in, const Cluster& cluster) {
    WallLanes w;
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) {
        const WallState& particle = in.wall[cluster.first + std::min(lane, cluster.count - 1)];
        w.x.lanes[lane] = particle.x;
        w.y.lanes[lane] = particle.y;
        w.vx.lanes[lane] = particle.vx;
        w.vy.lanes[lane] = particle.vy;
        w.nx.lanes[lane] = particle.nx;
        w.ny.lanes[lane] = particle.ny;
        w.drive_x.lanes[lane] = particle.ax - in.gravity.x();
        w.drive_y.lanes[lane] = particle.ay - in.gravity.y();
    }
    return w;
}

/// The fluid in front of each particle's face counts: what is behind a thin body belongs to its other face.
void wall_means(const PassInput& in) {
    const auto cluster_count = static_cast<std::int64_t>(in.wall_clusters->size());
    const double inverse_h = 1 / in.kernel.smoothing_length;
#pragma omp parallel for schedule(static) num_threads(in.threads)
    for (std::int64_t n = 0; n < cluster_count; ++n) {
        const Cluster& cluster = (*in.wall_clusters)[static_cast<std::size_t>(n)];
        const WallLanes w = load(in, cluster);
        Pack pressure_sum = 0.0, weight_sum = 0.0, vx_sum = 0.0, vy_sum = 0.0;
        const std::uint32_t count =
            cluster.fluid_neighbours[0] + (in.wall_pressure_mean[1] ? cluster.fluid_neighbours[1] : 0);
        for (std::uint32_t k = 0; k < count; ++k) {
            const FluidState& f = in.fluid[cluster.neighbours[k]];
            const Separation s = separation(w, f.x, f.y);
            const Pack t = positive_part(2.0 - s.distance * inverse_h);
            const Pack behind = s.x * w.nx + s.y * w.ny;
            const Pack weight =
                select(behind > 0.0, 0.0, t * t * t * t * (2.0 * s.distance * inverse_h + 1.0));
            pressure_sum += weight * (f.pressure - f.density * (w.drive_x * s.x + w.drive_y * s.y));
            weight_sum += weight;
            vx_sum += weight * f.vx;
            vy_sum += weight * f.vy;
        }
        const Pack inverse = 1.0 / maximum(weight_sum, 1e-300);
        const Pack pressure = pressure_sum * inverse, vx = vx_sum * inverse, vy = vy_sum * inverse;
        for (std::uint32_t lane = 0; lane < cluster.count; ++lane) {
            in.new_wall_mean[cluster.first + lane] = {pressure.lanes[lane], vx.lanes[lane], vy.lanes[lane]};
        }
    }
}

// --- momentum: dv_i/dt = (2/rho_i) SUM_j V_j P* F r_ij / r + g, Eq. (12)
// ----------------------------------------------

struct VectorSum {
    Pack x = 0.0, y = 0.0;
};

template <bool harmonic, bool dissipative, bool viscous, bool switched>
WETDECK_INLINE void momentum_sum(const PassInput& in, const Lanes& i, const std::uint32_t* neighbours,
                                 std::uint32_t count, const PairCoefficients& c, VectorSum& sum) {
    const double inverse_h = 1 / in.kernel.smoothing_length;
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
        sum.x += weight * s.x;
        sum.y += weight * s.y;
    }
}

/// P* between a fluid particle and a boundary particle; either side may be the pack. (sx, sy) leads from the
/// wall to the fluid, (vx, vy) is the fluid's velocity relative to the wall. A fluid particle behind the face
/// takes the one-sided pressure: the mean there is that of the other side of a thin body.
template <bool no_slip, bool shepard, class Fluid, class Wall>
WETDECK_INLINE Pack wall_p_star(Fluid pressure, Fluid density, Pack sx, Pack sy, Pack vx, Pack vy,
                                Pack inverse_distance, Wall nx, Wall ny, Wall drive_x, Wall drive_y,
                                Wall mean_pressure, const WallCoefficients& c) {
    const Pack height = sx * nx + sy * ny;
    const Pack one_sided = one_sided_pressure(Pack(pressure), Pack(density), sx, sy, drive_x, drive_y);
    Pack p_right = one_sided;
    if constexpr (shepard) p_right = select(height > 0.0, mean_pressure, one_sided);
    const Pack receding = vx * nx + vy * ny;
    const Pack approach = select(height > 0.0, -receding, receding);
    Pack p_star = 0.5 * (pressure + p_right) + riemann_dissipation(approach, c.limiter);
    if constexpr (no_slip) {
        const Pack closing = -(vx * sx + vy * sy) * inverse_distance;
        p_star += c.viscosity * maximum(2.0 * closing, c.lowest_viscous_jump);
    }
    return p_star;
}

template <bool no_slip, bool shepard>
void wall_momentum_sum(const PassInput& in, const Lanes& i, const std::uint32_t* neighbours,
                       std::uint32_t count, const WallCoefficients& c, VectorSum& sum) {
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
    sum.x += in.wall_volume * wall.x;
    sum.y += in.wall_volume * wall.y;
}

/// The same pairs seen from eight boundary particles: minus twice V_i V_w P* F r_iw / r, less the slope
/// factor.
template <bool no_slip, bool shepard>
void reaction_sum(const PassInput& in, const WallLanes& w, Pack mean, const std::uint32_t* neighbours,
                  std::uint32_t count, const WallCoefficients& c, VectorSum& sum) {
    const double inverse_h = 1 / in.kernel.smoothing_length;
    for (std::uint32_t n = 0; n < count; ++n) {
        const FluidState& f = in.fluid[neighbours[n]];
        const Separation s = separation(w, f.x, f.y);
        const Pack p_star =
            wall_p_star<no_slip, shepard>(f.pressure, f.density, -s.x, -s.y, f.vx - w.vx, f.vy - w.vy,
                                          s.inverse_distance, w.nx, w.ny, w.drive_x, w.drive_y, mean, c);
        const Pack weight = f.volume * WendlandC2::cubed_reach(s.distance, inverse_h) * p_star;
        sum.x += weight * s.x;
        sum.y += weight * s.y;
    }
}

/// Force of the fluid on each boundary particle of a body, Eq. (20): minus the forces of its pairs.
template <bool no_slip>
void body_forces(const PassInput& in) {
    const auto cluster_count = static_cast<std::int64_t>(in.wall_clusters->size());
    const double factor = 2 * in.kernel.slope_factor() * in.wall_volume;
#pragma omp parallel for schedule(static) num_threads(in.threads)
    for (std::int64_t n = 0; n < cluster_count; ++n) {
        const Cluster& cluster = (*in.wall_clusters)[static_cast<std::size_t>(n)];
        if (cluster.first < in.fixed_walls) continue;
        const WallLanes w = load(in, cluster);
        Pack mean;
        for (std::uint32_t lane = 0; lane < cluster_width; ++lane) {
            mean.lanes[lane] = in.wall_mean[cluster.first + std::min(lane, cluster.count - 1)].pressure;
        }
        const std::uint32_t* neighbours = cluster.neighbours;
        VectorSum sum;
        for (std::size_t phase = 0; phase < phase_count; ++phase) {
            const std::uint32_t count = cluster.fluid_neighbours[phase];
            const auto reaction =
                in.wall_pressure_mean[phase] ? reaction_sum<no_slip, true> : reaction_sum<no_slip, false>;
            reaction(in, w, mean, neighbours, count, in.wall_pair[phase], sum);
            neighbours += count;
        }
        store(factor * sum.x, in.wall_force_x, cluster);
        store(factor * sum.y, in.wall_force_y, cluster);
    }
}

template <bool harmonic, bool dissipative, bool viscous, bool switched, bool no_slip>
void accelerations(const PassInput& in) {
    const auto cluster_count = static_cast<std::int64_t>(in.clusters->size());
#pragma omp parallel for schedule(static) num_threads(in.threads)
    for (std::int64_t n = 0; n < cluster_count; ++n) {
        const Cluster& cluster = (*in.clusters)[static_cast<std::size_t>(n)];
        const auto phase_i = static_cast<std::size_t>(cluster.phase);
        const Lanes i = load(in.fluid, cluster.first, cluster.count);
        const std::uint32_t* neighbours = cluster.neighbours;
        VectorSum sum;
        for (std::size_t phase = 0; phase < phase_count; ++phase) {
            const std::uint32_t count = cluster.fluid_neighbours[phase];
            momentum_sum<harmonic, dissipative, viscous, switched>(in, i, neighbours, count,
                                                                   in.pair[phase_i][phase], sum);
            neighbours += count;
        }
        const bool shepard = in.wall_pressure_mean[phase_i];
        const auto wall_sum = shepard ? wall_momentum_sum<no_slip, true> : wall_momentum_sum<no_slip, false>;
        wall_sum(in, i, neighbours, cluster.wall_neighbours, in.wall_pair[phase_i], sum);
        const Pack factor = 2 * in.kernel.slope_factor() / i.density;
        store(factor * sum.x + in.gravity.x(), in.acceleration_x, cluster);
        store(factor * sum.y + in.gravity.y(), in.acceleration_y, cluster);
    }
}

// --- density and equation of state
// -----------------------------------------------------------------------------------

template <class Power>
void advance_phase(FluidState* state, const double* rate, const double* mass, std::size_t first,
                   std::size_t last, double dt, const TaitEquationOfState& eos, double lowest_density,
                   int threads, Power power) {
    const auto blocks = static_cast<std::int64_t>((last - first + cluster_width - 1) / cluster_width);
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t block = 0; block < blocks; ++block) {
        const std::size_t begin = first + static_cast<std::size_t>(block) * cluster_width;
        const std::size_t count = std::min<std::size_t>(cluster_width, last - begin);
        Pack density = eos.reference_density;
        for (std::size_t lane = 0; lane < count; ++lane) {
            density.lanes[lane] = state[begin + lane].density + dt * rate[begin + lane];
        }
        density = maximum(density, lowest_density);
        const Pack ratio = density * (1 / eos.reference_density);
        const Pack pressure = eos.coefficient() * (power(ratio) - 1.0) + eos.background_pressure;
        for (std::size_t lane = 0; lane < count; ++lane) {
            FluidState& particle = state[begin + lane];
            particle.density = density.lanes[lane];
            particle.volume = mass[begin + lane] / density.lanes[lane];
            particle.pressure = pressure.lanes[lane];
        }
    }
}

void advance_density(FluidState* state, const double* rate, const double* mass, std::size_t first,
                     std::size_t last, double dt, const TaitEquationOfState& eos, double lowest_density,
                     int threads) {
    const auto advance = [&](auto power) {
        advance_phase(state, rate, mass, first, last, dt, eos, lowest_density, threads, power);
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
// --------------------------------------------------------------------------------------------------

std::uint32_t filter_near(const FluidState* cluster, std::uint32_t count, const double* candidates,
                          std::size_t stride, std::uint32_t begin, std::uint32_t end, double reach,
                          std::uint32_t* out) {
    const Lanes i = load(cluster, 0, count);
    const Pack reach2 = reach * reach;
    std::uint32_t found = 0;
    for (std::uint32_t candidate = begin; candidate < end; ++candidate) {
        const double* position = candidates + candidate * stride;
        const Pack x = i.x - position[0];
        const Pack y = i.y - position[1];
        out[found] = candidate;
        found += any(x * x + y * y < reach2) ? 1 : 0;
    }
    return found;
}

// --- choice of the passes, once per run
// ------------------------------------------------------------------------------

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
    loops.body_forces = model.wall_slip == WallSlip::no ? body_forces<true> : body_forces<false>;
    loops.advance_density = advance_density;
    loops.filter_near = filter_near;
    return loops;
}

}  // namespace wetdeck::WETDECK_ISA
