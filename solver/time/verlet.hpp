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

/// Advances the flow by one step of the slow fluid. The flow must hold the rates of the last one, or of an
/// evaluation with the weight `substeps`.
/// @param substeps  steps of the fast fluid in it, m
/// @param extremes  set to those at the end of the step
/// @param particle_steps  grows by the particles whose pairs have been summed
///
/// Returns what has left its range, if anything; its time and step are left to the caller.
std::optional<Instability> advance(Flow& flow, Rates& rates, double step, int substeps,
                                   const StabilityBounds& bounds, Extremes& extremes,
                                   std::uint64_t& particle_steps);

}  // namespace wetdeck
