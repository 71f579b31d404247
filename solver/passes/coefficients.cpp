// SPDX-License-Identifier: BSD-3-Clause
#include "solver/passes/coefficients.hpp"

namespace wetdeck {
namespace {

const Material& material(const Model& model, Phase phase) {
    return phase == Phase::water ? model.water : model.air;
}

/// Weights of left and right in a mean of velocities: the heavier, the more.
MeanWeights velocity_weights(Mean mean, const Material& left, const Material& right) {
    switch (mean) {
        case Mean::density_weighted:
            return weights_by(left.eos.reference_density, right.eos.reference_density);
        case Mean::impedance_weighted:
            return weights_by(left.impedance(), right.impedance());
        case Mean::arithmetic:
        case Mean::harmonic:
            break;
    }
    return {};
}

/// Weights of left and right in a mean of pressures: the other way round.
MeanWeights pressure_weights(Mean mean, const Material& left, const Material& right) {
    const MeanWeights w = velocity_weights(mean, left, right);
    return {w.right, w.left};
}

double lowest_viscous_jump(Viscosity form) {
    return form == Viscosity::symmetric ? -1e300 : 0;
}

}  // namespace

PairCoefficients pair_coefficients(const Model& model, Phase left, Phase right, double smoothing_length) {
    const Material& l = material(model, left);
    const Material& r = material(model, right);
    const double impedance = harmonic_mean(l.impedance(), r.impedance());
    PairCoefficients c;
    c.weight_right = velocity_weights(model.velocity_mean, l, r).right;
    if (model.impedance_mean == ImpedanceMean::harmonic) {
        // 1 / (2 harmonic mean) = (1/Z_l + 1/Z_r) / 4, each share at the present density of its particle
        c.mobility = 0.25 * model.pressure_diffusion / l.impedance();
        c.right_mobility = 0.25 * model.pressure_diffusion * r.eos.reference_density / r.impedance();
    } else {
        c.mobility = model.pressure_diffusion / (l.impedance() + r.impedance());
    }
    // Half the way from water to air is through either: the surface of a still column then leaks half as fast
    // as with a harmonic mean.
    c.hydrostatic_density = 0.5 * (l.eos.reference_density + r.eos.reference_density);
    const MeanWeights p = pressure_weights(model.pressure_mean, l, r);
    c.pressure_weight_left = p.left;
    c.pressure_weight_right = p.right;
    c.limiter.half_impedance = 0.5 * impedance;
    const bool with_air = left == Phase::air || right == Phase::air;
    if (model.dissipation == Dissipation::riemann) {
        c.limiter.floor = 1;
    } else if (with_air) {
        c.limiter.floor = model.air_dissipation;
    } else {
        c.limiter.slope_over_speed = model.dissipation_slope / l.eos.sound_speed;
    }
    if (l.viscosity > 0 && r.viscosity > 0) {
        c.viscosity =
            viscosity_lambda(model.viscosity) * harmonic_mean(l.viscosity, r.viscosity) / smoothing_length;
    }
    c.lowest_viscous_jump = lowest_viscous_jump(model.viscosity);
    c.half_density = 0.5 * harmonic_mean(l.eos.reference_density, r.eos.reference_density);
    return c;
}

WallCoefficients wall_coefficients(const Model& model, Phase phase, double smoothing_length) {
    const Material& fluid = material(model, phase);
    WallCoefficients c;
    c.limiter.half_impedance = fluid.impedance();
    c.limiter.slope_over_speed = model.wall_dissipation / fluid.eos.sound_speed;
    if (model.viscosity != Viscosity::none) {
        c.viscosity = viscosity_lambda(model.viscosity) * fluid.viscosity / smoothing_length;
    }
    c.lowest_viscous_jump = lowest_viscous_jump(model.viscosity);
    if (model.wall_pressure_jump)
        c.jump_half_slowness = 0.5 * model.pressure_diffusion / fluid.eos.sound_speed;
    return c;
}

}  // namespace wetdeck
