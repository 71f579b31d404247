// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/ingredients.hpp"

#include "tests/support/samples.hpp"

namespace wetdeck::samples {

const std::vector<Ingredient>& ingredients() {
    static const std::vector<Ingredient> all = {
        {"default", [](Model&) {}},
        {"arithmetic velocity mean", [](Model& m) { m.velocity_mean = Mean::arithmetic; }},
        {"density-weighted velocity mean", [](Model& m) { m.velocity_mean = Mean::density_weighted; }},
        {"harmonic velocity mean", [](Model& m) { m.velocity_mean = Mean::harmonic; }},
        {"arithmetic pressure mean", [](Model& m) { m.pressure_mean = Mean::arithmetic; }},
        {"density-weighted pressure mean", [](Model& m) { m.pressure_mean = Mean::density_weighted; }},
        {"harmonic pressure mean", [](Model& m) { m.pressure_mean = Mean::harmonic; }},
        {"harmonic velocity mean of one sign, else arithmetic",
         [](Model& m) {
             m.velocity_mean = Mean::harmonic;
             m.mean_guard = MeanGuard::same_sign_arithmetic;
         }},
        {"harmonic velocity mean of one sign, else zero",
         [](Model& m) {
             m.velocity_mean = Mean::harmonic;
             m.mean_guard = MeanGuard::same_sign_zero;
         }},
        {"harmonic pressure mean of positive pressures, else arithmetic",
         [](Model& m) {
             m.pressure_mean = Mean::harmonic;
             m.mean_guard = MeanGuard::same_sign_arithmetic;
             m.water.eos.background_pressure = m.air.eos.background_pressure = 0;
         }},
        {"harmonic mean of rho c", [](Model& m) { m.impedance_mean = ImpedanceMean::harmonic; }},
        {"no pressure diffusion", [](Model& m) { m.pressure_diffusion = 0; }},
        {"hydrostatic jump kept", [](Model& m) { m.hydrostatic_correction = false; }},
        {"no dissipation", [](Model& m) { m.dissipation = Dissipation::none; }},
        {"full Riemann dissipation", [](Model& m) { m.dissipation = Dissipation::riemann; }},
        {"viscosity of approaching pairs", [](Model& m) { m.viscosity = Viscosity::approaching; }},
        {"viscosity of both signs", [](Model& m) { m.viscosity = Viscosity::symmetric; }},
        {"dissipation switch", [](Model& m) { m.dissipation_switch = true; }},
        {"switch without other dissipation",
         [](Model& m) {
             m.dissipation = Dissipation::none;
             m.dissipation_switch = true;
         }},
        {"switch with the harmonic mean of the projections",
         [](Model& m) {
             m.dissipation_switch = true;
             m.switch_velocity = SwitchVelocity::harmonic;
             m.mean_guard = MeanGuard::same_sign_arithmetic;
         }},
        {"switch with the modulus of the mean velocity",
         [](Model& m) {
             m.dissipation_switch = true;
             m.switch_velocity = SwitchVelocity::modulus;
         }},
        {"harmonic mean of pressures at walls",
         [](Model& m) {
             m.wall_pair_mean = WallPairMean::harmonic;
             m.mean_guard = MeanGuard::same_sign_arithmetic;
         }},
        {"harmonic mean of one-sided pressures at walls, else zero",
         [](Model& m) {
             m.wall_pair_mean = WallPairMean::harmonic;
             m.wall_pressure = WallPressure::one_sided;
             m.mean_guard = MeanGuard::same_sign_zero;
             m.water.eos.background_pressure = m.air.eos.background_pressure = 0;
         }},
        {"pressure jump at walls", [](Model& m) { m.wall_pressure_jump = true; }},
        {"no slip",
         [](Model& m) {
             m.wall_slip = WallSlip::no;
             m.viscosity = Viscosity::symmetric;
         }},
        {"no slip of approaching pairs",
         [](Model& m) {
             m.wall_slip = WallSlip::no;
             m.viscosity = Viscosity::approaching;
         }},
        {"one-sided wall pressure", [](Model& m) { m.wall_pressure = WallPressure::one_sided; }},
        {"Shepard wall pressure of both phases", [](Model& m) { m.wall_pressure = WallPressure::shepard; }},
        {"walls without the velocity along their face",
         [](Model& m) { m.wall_velocity = WallVelocity::normal; }},
        {"walls with their own normal velocity", [](Model& m) { m.wall_velocity = WallVelocity::own; }},
        {"mirrored walls with one-sided pressure",
         [](Model& m) {
             m.wall_velocity = WallVelocity::mirrored;
             m.wall_pressure = WallPressure::one_sided;
         }},
        {"no wall dissipation", [](Model& m) { m.wall_dissipation = 0; }},
        {"slanted gravity",
         [](Model& m) {
             m.gravity = {3, -7};
         }},
        {"the paper's formulas", [](Model& m) { m = paper_model(); }},
        {"no background pressure",
         [](Model& m) { m.water.eos.background_pressure = m.air.eos.background_pressure = 0; }},
    };
    return all;
}

Model with(const Ingredient& ingredient) {
    Model model = two_phase_model();
    model.water.viscosity = 20;  // large enough for the viscous part to show beside the others
    model.air.viscosity = 0.5;
    ingredient.switch_on(model);
    return model;
}

}  // namespace wetdeck::samples
