// SPDX-License-Identifier: BSD-3-Clause
// The stable time step, Yang et al. (2020), Eq. (26), over both phases, and the limit of an
// explicit diffusion of density by the pressure jump:
//     dt = min( C h/(c + v_max), 1.4 C h c_0 / (f c^2), 0.125 rho h^2 / mu, 0.25 sqrt(h/|g|) )
// with c = c_0 (rho/rho_0)^((gamma - 1)/2) of the most compressed fluid and f the factor on the
// pressure jump. The paper has C = 0.25, the default is 0.5: the second criterion is then
// 0.7 h c_0 / (f c^2). From 0.77 on, with h = 1.5 dx, a pressure that changes its sign from row to
// row of a square lattice grows. Where the air takes m steps in one of the water, the criteria of
// the air bound a step of the water at m times their size; where fine water takes m steps in one of the
// coarse, so do those of the fine water, and the last one has the h of the coarse.
#pragma once

#include <array>
#include <vector>

#include "solver/particles/fluid.hpp"
#include "solver/physics/model.hpp"

namespace wetdeck {

/// The bounds on the step, in the order of their names. A fixed step is within the other criteria or
/// beyond them.
enum class LimitingCriterion {
    acoustic_water,
    acoustic_air,
    viscous,
    force,
    fixed,
    fixed_beyond,
    contact,
    diffusion
};
/// As a run stores them.
inline constexpr std::array limiting_criterion_names = {
    "acoustic_water", "acoustic_air",           "viscous", "force",
    "fixed",          "fixed_beyond_criterion", "contact", "diffusion"};

/// A step and what set its size.
struct TimeStep {
    double size = 0;                                                  ///< [s]
    LimitingCriterion criterion = LimitingCriterion::acoustic_water;  ///< the smallest of them
};

/// Extremes of a flow, by phase: they set the next step.
struct Extremes {
    std::array<double, phase_count> fastest{};      ///< largest speed [m/s]
    std::array<double, phase_count> densest{1, 1};  ///< largest density over the reference, at least 1
};

/// Steps of the air in one of the water: as the model says or, where it says 0, the odd number up to 15 that
/// the sound speeds allow with room for fast water. Throws InputError for an even number, and for more than
/// one with the dissipation switch, which needs the whole rates at each step.
int air_substeps(const Model& model);

/// Steps of fine water in one of the coarse, which is as many times coarser than the finest, or more: as the
/// model says or, where it says 0, the odd number that leaves the fewest particle-steps, or 1 where that
/// spares less than a tenth of them. Throws InputError for an even number, and for more than one with the
/// dissipation switch.
/// @param finenesses  of the particles
int coarse_substeps(const Model& model, const std::vector<double>& finenesses);

/// The stable step of the slow fluid, which is that of the whole model.
/// @param model             for its fluids and its Courant number
/// @param smoothing_length  h [m]
/// @param extremes          of the present state
/// @param has_water         a phase without particles does not limit
/// @param has_air           likewise
/// @param coarse_substeps   steps of fine water in one of the coarse; h is that of the fine
TimeStep stable_time_step(const Model& model, double smoothing_length, const Extremes& extremes,
                          bool has_water, bool has_air, int coarse_substeps = 1);

/// The step, or a shorter one that resolves contact: a fifth of 1/omega, a tenth of what velocity Verlet
/// bears.
/// @param frequency  highest angular frequency omega of the contacts, 0 without any [1/s]
TimeStep with_contact(TimeStep step, double frequency);

/// The step that a model takes: the stable one, or its fixed step.
TimeStep step_of(const Model& model, TimeStep stable);

}  // namespace wetdeck
