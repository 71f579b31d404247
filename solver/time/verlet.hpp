// SPDX-License-Identifier: BSD-3-Clause
// Velocity Verlet as in Adami, Hu and Adams (2012). One step: half kick and half drift; density from the
// rates at the middle; half drift; accelerations at the end; half kick. Two passes over the pairs. Rigid
// bodies go through the same kicks and drifts.
//
// Where sound is faster in the air, the air takes m such steps, m odd, in one of the water (the impulse
// method of molecular dynamics); in water alone, the fine particles in one of those that are m times as
// coarse or more. Pairs of slow fluid with slow fluid and walls, and its weight, accelerate it in the first
// and the last half kick and compress it in the middle step, each time with the weight of all m steps; pairs
// with fast fluid count in each step.
#pragma once

#include <array>
#include <optional>

#include "solver/passes/rates.hpp"
#include "solver/time/stability.hpp"
#include "solver/time/time_step.hpp"

namespace wetdeck {

/// The extremes of the present state.
Extremes extremes_of(const FluidParticles& fluid, const Model& model);

/// One step of the fast fluid among those that make a step of the slow one.
struct Substep {
    double dt = 0;   ///< [s]
    int number = 0;  ///< from 0
    int count = 1;   ///< m

    bool middle() const { return number == count / 2; }  ///< whether it compresses the slow fluid
    bool last() const { return number == count - 1; }    ///< whether it ends the step of the slow fluid
};

/// Advances the flow by one step of the fast fluid. The flow must hold the rates of the last one, or of an
/// evaluation with the weight `count`.
/// @param extremes  set to those at the end of the step
///
/// Returns what has left its range, if anything; its time and step are left to the caller.
std::optional<Instability> advance(Flow& flow, Rates& rates, const Substep& substep,
                                   const StabilityBounds& bounds, Extremes& extremes);

}  // namespace wetdeck
