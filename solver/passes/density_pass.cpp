// SPDX-License-Identifier: BSD-3-Clause
// The pass of the continuity equation, Yang et al. (2020), Eq. (12):
//     d(rho_i)/dt = 2 rho_i SUM_j V_j F (u_L - u*)
// and, where it bounds the density of water, the kernel sum S_i = SUM_j V_j W_ij.
#include "solver/passes/isa_passes.hpp"
#include "solver/passes/simd/mixed_lanes.hpp"
#include "solver/passes/simd/pair_kernel.hpp"
#include "solver/passes/substep_weight.hpp"
#include "solver/physics/density_bounds.hpp"
#include "solver/physics/riemann.hpp"
#include "solver/physics/wall_boundary.hpp"

namespace wetdeck::WETDECK_ISA {
namespace {

/// What the pass computes, resolved at compile time.
struct DensityTerms {
    bool harmonic_velocity;       ///< the velocity mean is harmonic, by component
    bool harmonic_impedance;      ///< the mean of rho c is harmonic, of the present states
    bool hydrostatic_correction;  ///< the hydrostatic jump is taken out of the pressure jump
    bool mirrored_walls;          ///< walls move along their face with the water
    bool kernel_sum;              ///< the kernel sum is wanted
    bool water;                   ///< of water, which feels a wall once it touches it
    bool graded;                  ///< particles differ in their spacings
};

template <class Number>
struct DensitySumsOf {
    Number rate = 0.0, kernel_sum = 0.0;
};
using DensitySums = DensitySumsOf<Pack>;

/// The sum over the neighbours of one group. F (u_L - u*) is taken with F = r W', so that nothing is divided
/// by r: r u = -v . r_ij.
/// @param mobility  of the pair at the present density
template <class Precise, DensityTerms terms>
WETDECK_INLINE DensitySums fluid_sum(const PassInput& in, const typename Precise::Fluid& i,
                                     Neighbours neighbours, const PairCoefficients& c,
                                     typename Precise::Number mobility) {
    using Number = typename Precise::Number;
    const double unit = Precise::unit_of_length(in);
    const PairKernels<terms.graded, Number> kernels(in, unit, i);
    const double gx = unit * c.hydrostatic_density * in.gravity.x(),
                 gy = unit * c.hydrostatic_density * in.gravity.y();
    DensitySumsOf<Number> sums;
    for (const auto& j : Precise::each(in, neighbours)) {
        const SeparationOf<Number> s = separation(i, j.x, j.y);
        const auto kernel = kernels.with(j);
        Number jump = i.pressure - j.pressure;
        if constexpr (terms.hydrostatic_correction) jump = jump - (gx * s.x + gy * s.y);
        Number pair_mobility = mobility;
        if constexpr (terms.harmonic_impedance) pair_mobility = mobility + c.right_mobility / j.density;
        Number left_less_star;
        if constexpr (terms.harmonic_velocity) {  // v* . e of the mean of vectors, by component
            const Number vx = harmonic_mean(i.vx, Number(j.vx), in.model->mean_guard, in.smallest_velocity);
            const Number vy = harmonic_mean(i.vy, Number(j.vy), in.model->mean_guard, in.smallest_velocity);
            left_less_star = (vx - i.vx) * s.x + (vy - i.vy) * s.y - pair_mobility * jump * s.distance;
        } else {
            const Number approach = (j.vx - i.vx) * s.x + (j.vy - i.vy) * s.y;
            left_less_star =
                velocity_left_less_star(approach, jump * s.distance, c.weight_right, pair_mobility);
        }
        sums.rate += j.volume * kernel.gradient_shape(s.distance) * left_less_star;
        if constexpr (terms.kernel_sum) sums.kernel_sum += j.volume * kernel.shape(s.distance);
    }
    return {unit * Precise::total(sums.rate), Precise::total(sums.kernel_sum)};
}

/// What the sums over boundary particles yield for a cluster, less the volume of the finest of them.
struct WallSums {
    Pack rate = 0.0, kernel_sum = 0.0;
    Pack face_distance = 0.0;  ///< from the face of the nearest boundary particle [spacings]
};

/// Free slip and no slip alike: the wall reverses the normal velocity about its own and has no pressure jump;
/// an edge of a body, which has no normal, reverses the whole velocity. A mirrored wall moves along its face
/// with the water around it. Water feels walls that it touches.
template <DensityTerms terms>
WallSums wall_sum(const PassInput& in, const Lanes& i, Neighbours neighbours) {
    const PairKernels<terms.graded, Pack> kernels(in, 1, i);
    Pack sum = 0.0, stretching = 0.0, kernel_sum = 0.0, room = 0.0, wet = 0.0;
    constexpr double least_room = 1e-12;
    // Signed distance from the layer of the nearest boundary particle: it tells the particle's own face, so
    // that the other face of a thin body, or of an edge, does not count.
    Pack closest = in.coarsest * in.kernel.support_radius(), own_distance = in.kernel.smoothing_length;
    for (const std::uint32_t index : neighbours) {
        const WallState& w = in.wall[index];
        const Separation s = separation(i, w.x, w.y);
        const auto kernel = kernels.with_wall(in, index);
        const Pack weight = kernel.wall_volume * kernel.gradient_shape(s.distance);
        if constexpr (terms.water) {
            const Pack share = kernel.wall_volume * kernel.shape(s.distance);
            if constexpr (terms.kernel_sum) kernel_sum += share;
            const Pack open = share * (1 - in.wall_own_sum[index]);
            room += open;
            wet += open * in.wall_mean[index].wetness;
        }
        const bool edge = w.nx == 0 && w.ny == 0;
        const Pack signed_distance = edge ? s.distance : s.x * w.nx + s.y * w.ny;
        if constexpr (terms.water) {
            Pack in_spacings = signed_distance, reached = s.distance;
            if constexpr (terms.graded) {
                in_spacings = in.wall_fineness[index] * signed_distance;
                reached = select(weight > 0.0, s.distance, closest);  // within this pair's support
            }
            own_distance = select(reached < closest, in_spacings, own_distance);
            closest = minimum(closest, reached);
        }
        if (edge) {
            sum = sum - weight * ((i.vx - w.vx) * s.x + (i.vy - w.vy) * s.y);
        } else {
            const Pack approach = -((i.vx - w.vx) * w.nx + (i.vy - w.vy) * w.ny);
            sum += weight * approach * signed_distance;
            if constexpr (terms.mirrored_walls) {
                const WallMean& mean = in.wall_mean[index];
                const Pack slip = (i.vy - mean.vy) * w.nx - (i.vx - mean.vx) * w.ny;
                const Pack along = s.y * w.nx - s.x * w.ny;
                stretching += select(signed_distance > 0.0, weight * slip * along, 0.0);
            }
        }
    }
    const Pack face_distance = own_distance * (1 / in.particle_spacing) - 0.5;
    if constexpr (terms.water) {
        if (in.wetting) {
            const Pack share = wet / maximum(room, Pack(least_room));
            sum = sum * select(face_distance < touching_distance, Pack(1.0), share);
        }
    }
    if constexpr (terms.mirrored_walls) sum = sum - 0.5 * stretching_share(face_distance) * stretching;
    return {sum, kernel_sum, face_distance};
}

/// What the pressure jump of Eq. (17) adds to the sum over boundary particles: less u* along the normal, or
/// along the line of the pair at an edge, which has none.
template <bool graded>
Pack wall_jump_sum(const PassInput& in, const Lanes& i, Neighbours neighbours, double half_slowness) {
    const PairKernels<graded, Pack> kernels(in, 1, i);
    Pack sum = 0.0;
    for (const std::uint32_t index : neighbours) {
        const WallState& w = in.wall[index];
        const Separation s = separation(i, w.x, w.y);
        const bool edge = w.nx == 0 && w.ny == 0;
        const Pack signed_distance = edge ? s.distance : s.x * w.nx + s.y * w.ny;
        const Pack jump =
            wall_jump_velocity(s.x, s.y, w.ax - in.gravity.x(), w.ay - in.gravity.y(), half_slowness);
        const auto kernel = kernels.with_wall(in, index);
        sum = sum - kernel.wall_volume * kernel.gradient_shape(s.distance) * signed_distance * jump;
    }
    return sum;
}

/// The kernel sum of fluid and walls. Water that touches a face counts as fully supported.
WETDECK_INLINE Pack whole_kernel_sum(const PassInput& in, Pack fluid, const WallSums& walls) {
    const double inverse_norm = 1 / in.kernel.normalisation();
    const Pack touching = inverse_norm * (touching_kernel_sum + positive_part(-walls.face_distance));
    return select(walls.face_distance < touching_distance, touching,
                  fluid + in.wall_volume * walls.kernel_sum);
}

template <class Precise, DensityTerms terms>
WETDECK_INLINE void cluster_density_rates(const PassInput& in, const Cluster& cluster) {
    if (idle(in, cluster)) return store(0.0, in.density_rate, cluster);
    const typename Precise::Fluid i = Precise::load(in, cluster);
    const auto phase_i = static_cast<std::size_t>(cluster.phase);
    const typename Precise::Number reference_over_density = in.reference_density[phase_i] / i.density;
    const double slow_weight = substep_weight(in, cluster);
    DensitySums sums;
    for (std::size_t group = 0; group < group_count; ++group) {
        const double weight = group == 1 ? 1 : slow_weight;
        if (!(weight > 0)) continue;
        const PairCoefficients& c = in.pair[phase_i][in.phase_of[group]];
        const DensitySums fluid = fluid_sum<Precise, terms>(
            in, i, fluid_neighbours(*in.blocks, cluster, group), c, c.mobility * reference_over_density);
        sums.rate += weight * fluid.rate;
        if constexpr (terms.kernel_sum) sums.kernel_sum += fluid.kernel_sum;
    }
    if (cluster.wall_neighbours > 0 && slow_weight > 0) {
        const Lanes& beside = Precise::beside_walls(in, cluster, i);
        WallSums walls = wall_sum<terms>(in, beside, wall_neighbours(*in.blocks, cluster));
        if (in.model->wall_velocity == WallVelocity::own) walls.rate = 0.5 * walls.rate;
        if (const double half_slowness = in.wall_pair[phase_i].jump_half_slowness; half_slowness > 0)
            walls.rate +=
                wall_jump_sum<terms.graded>(in, beside, wall_neighbours(*in.blocks, cluster), half_slowness);
        sums.rate += slow_weight * in.wall_volume * walls.rate;
        if constexpr (terms.kernel_sum) sums.kernel_sum = whole_kernel_sum(in, sums.kernel_sum, walls);
    }
    store(2 * in.kernel.slope_factor() * Precise::of_cluster(i.density) * sums.rate, in.density_rate,
          cluster);
    if constexpr (terms.kernel_sum)
        store(in.kernel.normalisation() * sums.kernel_sum, in.kernel_sum, cluster);
}

/// The same without a kernel sum.
template <DensityTerms terms>
constexpr DensityTerms without_sum = {terms.harmonic_velocity,
                                      terms.harmonic_impedance,
                                      terms.hydrostatic_correction,
                                      terms.mirrored_walls,
                                      false,
                                      true,
                                      terms.graded};
/// The same for the air.
template <DensityTerms terms>
constexpr DensityTerms of_air = {terms.harmonic_velocity,
                                 terms.harmonic_impedance,
                                 terms.hydrostatic_correction,
                                 false,
                                 false,
                                 false,
                                 terms.graded};

template <class Precise, DensityTerms terms>
void density_rates(const PassInput& in) {
    in.clusters.for_each([&in](const Cluster& cluster, int) {
        if (cluster.phase == Phase::air) {
            cluster_density_rates<Precise, of_air<terms>>(in, cluster);
        } else if (in.kernel_sum && !drifts(in, cluster)) {
            cluster_density_rates<Precise, terms>(in, cluster);
        } else {
            cluster_density_rates<Precise, without_sum<terms>>(in, cluster);
        }
    });
}

/// The passes of means that are linear in the values.
template <class Precise>
Pass with_linear_means(const Model& model, bool graded) {
    return with_flags(
        []<bool is_graded, bool... flags>()->Pass {
            return density_rates<Precise, DensityTerms{false, false, flags..., true, true, is_graded}>;
        },
        graded, model.hydrostatic_correction, model.wall_velocity == WallVelocity::mirrored);
}

}  // namespace

Pass density_pass(const Model& model, Precision precision, bool graded) {
    if (precision == Precision::mixed) return with_linear_means<InMixed>(model, graded);
    if (graded) return with_linear_means<InDouble>(model, true);
    const bool mirrored = model.wall_velocity == WallVelocity::mirrored;
    return with_flags(
        []<bool... flags>()->Pass {
            return density_rates<InDouble, DensityTerms{flags..., true, true, false}>;
        },
        model.velocity_mean == Mean::harmonic, model.impedance_mean == ImpedanceMean::harmonic,
        model.hydrostatic_correction, mirrored);
}

}  // namespace wetdeck::WETDECK_ISA
