// SPDX-License-Identifier: BSD-3-Clause
// The passes over boundary particles: means of the fluid around them and forces on bodies.
#include "solver/passes/isa_passes.hpp"
#include "solver/passes/simd/pair_kernel.hpp"
#include "solver/passes/wall_pair.hpp"
#include "solver/physics/wetting.hpp"

namespace wetdeck::WETDECK_ISA {
namespace {

/// Yang et al. (2020), Eq. (19): P_w = SUM_f [ P_f + rho_f (a_w - g) . (r_f - r_w) ] W_wf / SUM_f W_wf, the
/// mean velocity likewise, and the wetness. Only the fluid in front of a particle's face counts: fluid
/// behind a thin body belongs to its other face.
template <bool graded>
void wall_means(const PassInput& in) {
    const auto cluster_count = static_cast<std::int64_t>(in.wall_clusters->size());
    const bool fast_water = in.phase_of[1] == 0;
#pragma omp parallel for schedule(static) num_threads(in.threads)
    for (std::int64_t n = 0; n < cluster_count; ++n) {
        const Cluster& cluster = (*in.wall_clusters)[static_cast<std::size_t>(n)];
        if (fast_water && in.slow_weight == 0 && cluster.fluid_neighbours[1] == 0) continue;
        const WallLanes w = load(in, cluster);
        const PairKernels<graded, Pack> kernels(in, 1, w);
        Pack pressure_sum = 0.0, weight_sum = 0.0, vx_sum = 0.0, vy_sum = 0.0, kernel_sum = 0.0;
        const std::uint32_t count =
            cluster.fluid_neighbours[0] +
            (fast_water || in.wall_pressure_mean[1] ? cluster.fluid_neighbours[1] : 0);
        const std::uint32_t* neighbours = fluid_neighbours(*in.blocks, cluster, 0).data();
        for (std::uint32_t k = 0; k < count; ++k) {
            const FluidState& f = in.fluid[neighbours[k]];
            const Separation s = separation(w, f.x, f.y);
            const Pack behind = s.x * w.nx + s.y * w.ny;
            Pack weight = select(behind > 0.0, 0.0, kernels.with(f).shape(s.distance));
            kernel_sum += f.volume * weight;
            if constexpr (graded)
                weight = 1 / (f.fineness * f.fineness) * weight;  // by the area it was laid on
            pressure_sum += weight * (f.pressure - f.density * (w.relative_x * s.x + w.relative_y * s.y));
            weight_sum += weight;
            vx_sum += weight * f.vx;
            vy_sum += weight * f.vy;
        }
        const Pack inverse = 1.0 / maximum(weight_sum, 1e-300);
        const Pack pressure = pressure_sum * inverse, vx = vx_sum * inverse, vy = vy_sum * inverse;
        for (std::uint32_t lane = 0; lane < cluster.count; ++lane) {
            const std::uint32_t index = cluster.first + lane;
            const double cover =
                covered_share(kernel_sum.lanes[lane] * in.kernel.normalisation(), in.wall_own_sum[index]);
            in.new_wall_mean[index] = {pressure.lanes[lane], vx.lanes[lane], vy.lanes[lane],
                                       next_wetness(in.new_wall_mean[index].wetness, cover)};
        }
    }
}

/// The pairs of the momentum pass seen from eight boundary particles: minus twice V_i V_w P* F r_iw / r, less
/// the slope factor.
template <WallTerms terms>
void add_reactions(const PassInput& in, const WallLanes& w, Pack mean, Neighbours neighbours,
                   const WallCoefficients& c, VectorSum& sum) {
    const PairKernels<terms.graded, Pack> kernels(in, 1, w);
    const WallSide<Pack> wall = {w.nx, w.ny, w.relative_x, w.relative_y, mean};
    for (const std::uint32_t index : neighbours) {
        const FluidState& f = in.fluid[index];
        const Separation s = separation(w, f.x, f.y);
        const WallPairGeometry pair = {-s.x, -s.y, f.vx - w.vx, f.vy - w.vy, s.inverse_distance};
        const auto kernel = kernels.with(f);
        const Pack p_star =
            wall_p_star<terms>(in, FluidSide<double>{f.pressure, f.density}, wall, pair, kernel.fineness, c);
        const Pack weight = f.volume * kernel.gradient_shape(s.distance) * p_star;
        sum.x += weight * s.x;
        sum.y += weight * s.y;
    }
}

/// The reactions to the pairs of a phase.
template <bool no_slip, bool graded>
auto choose_reactions(const PassInput& in, std::size_t phase) {
    return with_flags(
        []<bool shepard, bool harmonic>() {
            return &add_reactions<WallTerms{no_slip, shepard, harmonic, graded}>;
        },
        in.wall_pressure_mean[phase], in.model->wall_pair_mean == WallPairMean::harmonic);
}

/// Force of the fluid on each boundary particle of a body, Eq. (20): minus the forces of its pairs.
template <bool no_slip, bool graded>
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
        VectorSum sum;
        for (std::size_t group = 0; group < group_count; ++group) {
            if (!in.loading[group]) continue;
            const std::size_t phase = in.phase_of[group];
            choose_reactions<no_slip, graded>(in, phase)(
                in, w, mean, fluid_neighbours(*in.blocks, cluster, group), in.wall_pair[phase], sum);
        }
        Pack volume = factor;
        if constexpr (graded) volume = factor / (w.fineness * w.fineness);
        store(volume * sum.x, in.wall_force_x, cluster);
        store(volume * sum.y, in.wall_force_y, cluster);
    }
}

}  // namespace

Pass wall_mean_pass(bool graded) {
    return graded ? wall_means<true> : wall_means<false>;
}

Pass body_force_pass(const Model& model, bool graded) {
    return with_flags(
        []<bool... flags>()->Pass { return body_forces<flags...>; }, model.wall_slip == WallSlip::no, graded);
}

}  // namespace wetdeck::WETDECK_ISA
