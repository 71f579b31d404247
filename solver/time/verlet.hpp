// SPDX-License-Identifier: BSD-3-Clause
// Velocity Verlet as in Adami, Hu and Adams (2012). One step: half kick and half drift; density from the
// rates at the middle; half drift; accelerations at the end; half kick. Two passes over the pairs. Rigid
// bodies go through the same kicks and drifts.
//
// Where sound is faster in the air, the air takes m such steps, m odd, in one of the water (the impulse
// method of molecular dynamics). Pairs of water with water and walls, and the water's weight, accelerate the
// water in the first and the last half kick and compress it in the middle step, each time with the weight of
// all m steps; pairs with air count in each step.
#pragma once

#include <array>
#include <optional>

#include "solver/passes/rates.hpp"
#include "solver/time/stability.hpp"
#include "solver/time/time_step.hpp"

namespace wetdeck {

/// The extremes of the present state.
Extremes extremes_of(const FluidParticles& fluid, const Model& model);

/// One step of the air among those that make a step of the water.
struct Substep {
    double dt = 0;   ///< [s]
    int number = 0;  ///< from 0
    int count = 1;   ///< m

    bool middle() const { return number == count / 2; }  ///< whether it compresses the water
    bool last() const { return number == count - 1; }    ///< whether it ends the step of the water
};

/// Advances the flow by one step of the air. The flow must hold the rates of the last one, or of an
/// evaluation with the weight `count`.
/// @param extremes  set to those at the end of the step
///
/// Returns what has left its range, if anything; its time and step are left to the caller.
std::optional<Instability> advance(Flow& flow, Rates& rates, const Substep& substep,
                                   const StabilityBounds& bounds, Extremes& extremes);

}  // namespace wetdeck
