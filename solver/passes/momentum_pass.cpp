// SPDX-License-Identifier: BSD-3-Clause
// The pass of the momentum equation, Yang et al. (2020), Eq. (12):
//     dv_i/dt = (2/rho_i) SUM_j V_j P* F r_ij / r + g
#include "solver/passes/isa_passes.hpp"
#include "solver/passes/simd/mixed_lanes.hpp"
#include "solver/passes/simd/pair_kernel.hpp"
#include "solver/passes/substep_weight.hpp"
#include "solver/passes/wall_pair.hpp"
#include "solver/physics/dissipation.hpp"
#include "solver/physics/riemann.hpp"

namespace wetdeck::WETDECK_ISA {
namespace {

/// What the pass computes, resolved at compile time.
struct MomentumTerms {
    bool harmonic_pressure;   ///< the pressure mean is harmonic
    bool dissipation_switch;  ///< Eqs. (14)-(15)
    bool dissipation;         ///< Riemann dissipation, Eq. (10)
    bool viscosity;           ///< physical viscosity, Eq. (13)
    bool no_slip;             ///< walls drag the fluid along, Eq. (18)
    bool graded;              ///< particles differ in their spacings
};

/// The velocity factor of Eq. (14).
template <class Number, class Left, class Right>
WETDECK_INLINE Number switch_velocity(const PassInput& in, const Left& i, const Right& j,
                                      const SeparationOf<Number>& s) {
    const Number sum_x = j.vx + i.vx, sum_y = j.vy + i.vy;
    if (in.model->switch_velocity == SwitchVelocity::modulus) {
        Number modulus, inverse;
        square_roots(0.25 * (sum_x * sum_x + sum_y * sum_y), modulus, inverse);
        return modulus;
    }
    Number mean = -0.5 * (sum_x * s.x + sum_y * s.y) * s.inverse_distance;
    if (in.model->switch_velocity == SwitchVelocity::harmonic) {
        const Number u_left = -(i.vx * s.x + i.vy * s.y) * s.inverse_distance;
        const Number u_right = -(j.vx * s.x + j.vy * s.y) * s.inverse_distance;
        mean = harmonic_mean(u_left, u_right, in.model->mean_guard, in.smallest_velocity);
    }
    return maximum(mean, -mean);
}

/// P* between the particles of a cluster and one neighbour.
/// @param fineness  of the pair
template <MomentumTerms terms, class Number, class Left, class Right, class Fineness>
WETDECK_INLINE Number fluid_p_star(const PassInput& in, const Left& i, const Right& j,
                                   const SeparationOf<Number>& s, const Fineness& fineness,
                                   const PairCoefficients& c) {
    Number p_star;
    if constexpr (terms.harmonic_pressure) {
        p_star = harmonic_mean_of_pressures(i.pressure, Number(j.pressure), in.model->mean_guard,
                                            in.smallest_pressure);
    } else {
        p_star = weighted_pressure(i.pressure, Number(j.pressure), c.pressure_weight_left,
                                   c.pressure_weight_right);
    }
    if constexpr (terms.dissipation || terms.viscosity || terms.dissipation_switch) {
        const Number jump = ((j.vx - i.vx) * s.x + (j.vy - i.vy) * s.y) * s.inverse_distance;
        if constexpr (terms.dissipation) p_star += riemann_dissipation(jump, c.limiter);
        if constexpr (terms.viscosity)
            p_star += fineness * c.viscosity * maximum(jump, c.lowest_viscous_jump);
        if constexpr (terms.dissipation_switch) {
            const Number on = maximum(i.impact, Number(j.impact));
            p_star += on * c.half_density * switch_velocity(in, i, j, s) * jump;
        }
    }
    return p_star;
}

template <class Precise, MomentumTerms terms>
VectorSum fluid_sum(const PassInput& in, const typename Precise::Fluid& i, Neighbours neighbours,
                    const PairCoefficients& c) {
    using Number = typename Precise::Number;
    const double unit = Precise::unit_of_length(in);
    const PairKernels<terms.graded, Number> kernels(in, unit, i);
    VectorSumOf<Number> sum;
    for (const auto& j : Precise::each(in, neighbours)) {
        const SeparationOf<Number> s = separation(i, j.x, j.y);
        const auto kernel = kernels.with(j);
        const Number p_star = fluid_p_star<terms>(in, i, j, s, kernel.fineness, c);
        const Number weight = j.volume * kernel.gradient_shape(s.distance) * p_star;
        sum.x += weight * s.x;
        sum.y += weight * s.y;
    }
    return {unit * Precise::total(sum.x), unit * Precise::total(sum.y)};
}

template <WallTerms terms>
VectorSum wall_sum(const PassInput& in, const Lanes& i, Neighbours neighbours, const WallCoefficients& c) {
    const PairKernels<terms.graded, Pack> kernels(in, 1, i);
    VectorSum sum;
    for (const std::uint32_t index : neighbours) {
        const WallState& w = in.wall[index];
        const Separation s = separation(i, w.x, w.y);
        const double mean = terms.shepard_pressure ? in.wall_mean[index].pressure : 0;
        const WallSide<double> wall = {w.nx, w.ny, w.ax - in.gravity.x(), w.ay - in.gravity.y(), mean};
        const WallPairGeometry pair = {s.x, s.y, i.vx - w.vx, i.vy - w.vy, s.inverse_distance};
        const auto kernel = kernels.with_wall(in, index);
        const Pack p_star =
            wall_p_star<terms>(in, FluidSide<Pack>{i.pressure, i.density}, wall, pair, kernel.fineness, c);
        const Pack weight = kernel.wall_volume * kernel.gradient_shape(s.distance) * p_star;
        sum.x += weight * s.x;
        sum.y += weight * s.y;
    }
    return sum;
}

/// The sum over walls that a phase takes.
template <bool no_slip, bool graded>
auto choose_wall_sum(const PassInput& in, std::size_t phase) {
    return with_flags(
        []<bool shepard, bool harmonic>() {
            return &wall_sum<WallTerms{no_slip, shepard, harmonic, graded}>;
        },
        in.wall_pressure_mean[phase], in.model->wall_pair_mean == WallPairMean::harmonic);
}

template <class Precise, MomentumTerms terms>
void accelerations(const PassInput& in) {
    in.clusters.for_each([&in](const Cluster& cluster, int) {
        if (idle(in, cluster)) {
            store(0.0, in.acceleration_x, cluster);
            return store(0.0, in.acceleration_y, cluster);
        }
        const auto phase_i = static_cast<std::size_t>(cluster.phase);
        const typename Precise::Fluid i = Precise::load(in, cluster);
        const double slow_weight = substep_weight(in, cluster);
        VectorSum sum;
        for (std::size_t group = 0; group < group_count; ++group) {
            const double weight = group == 1 ? 1 : slow_weight;
            if (!(weight > 0)) continue;
            const VectorSum fluid = fluid_sum<Precise, terms>(
                in, i, fluid_neighbours(*in.blocks, cluster, group), in.pair[phase_i][in.phase_of[group]]);
            sum.x += weight * fluid.x;
            sum.y += weight * fluid.y;
        }
        if (cluster.wall_neighbours > 0 && slow_weight > 0) {
            const VectorSum walls = choose_wall_sum<terms.no_slip, terms.graded>(in, phase_i)(
                in, Precise::beside_walls(in, cluster, i), wall_neighbours(*in.blocks, cluster),
                in.wall_pair[phase_i]);
            sum.x += slow_weight * in.wall_volume * walls.x;
            sum.y += slow_weight * in.wall_volume * walls.y;
        }
        const Pack factor = 2 * in.kernel.slope_factor() / Precise::of_cluster(i.density);
        store(factor * sum.x + slow_weight * in.gravity.x(), in.acceleration_x, cluster);
        store(factor * sum.y + slow_weight * in.gravity.y(), in.acceleration_y, cluster);
    });
}

/// The passes of means that are linear in the values.
template <class Precise>
Pass with_linear_means(const Model& model, bool graded) {
    return with_flags(
        []<bool is_graded, bool... flags>()->Pass {
            return accelerations<Precise, MomentumTerms{false, false, flags..., is_graded}>;
        },
        graded, model.dissipation != Dissipation::none, model.viscosity != Viscosity::none,
        model.wall_slip == WallSlip::no);
}

}  // namespace

Pass momentum_pass(const Model& model, Precision precision, bool graded) {
    if (precision == Precision::mixed) return with_linear_means<InMixed>(model, graded);
    if (graded) return with_linear_means<InDouble>(model, true);
    const bool dissipation = model.dissipation != Dissipation::none;
    const bool viscosity = model.viscosity != Viscosity::none, no_slip = model.wall_slip == WallSlip::no;
    return with_flags(
        []<bool... flags>()->Pass {
            return accelerations<InDouble, MomentumTerms{flags..., false}>;
        },
        model.pressure_mean == Mean::harmonic, model.dissipation_switch, dissipation, viscosity, no_slip);
}

}  // namespace wetdeck::WETDECK_ISA
