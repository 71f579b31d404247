// SPDX-License-Identifier: BSD-3-Clause
// Models with every field set, and small sets of particles to try them on.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "validation/verification/setups.hpp"

namespace wetdeck::samples {

using verification::Setup;

/// Water (c = 30 m/s) and air (c = 90 m/s), 1000 Pa of background pressure, impedance-weighted means, low
/// dissipation, no viscosity, free slip, Shepard pressure for water, one thread. No field is left to a
/// default.
Model two_phase_model();

/// The formulas of Yang et al. (2020) as printed: harmonic means, one-sided viscosity, dissipation switch.
Model paper_model();

/// Water in the lower left of a 1.0 x 0.8 m tank with walls and air around it, on a lattice that is shaken by
/// up to 0.3 spacings, with random velocities (2 m/s), densities (water 1 %, air 10 %) and impact marks;
/// walls move and accelerate.
Setup shaken_tank(const Model& model, std::uint64_t seed, double particle_spacing = 0.05);

/// A layer of water below air in a tank with walls, with spacings of 0.025 m in the middle that grow to four
/// times that, shaken like shaken_tank.
Setup graded_tank(const Model& model, std::uint64_t seed);
/// A longer layer without the air, finest near its left end.
Setup graded_water(const Model& model, std::uint64_t seed);

/// A shaken disc of water (radius 0.15 m) with a ring of air (to 0.25 m) about the origin, far from any wall.
Setup shaken_blob(const Model& model, std::uint64_t seed, double particle_spacing = 0.025);

/// A column of water in the left of a closed tank with air in the rest, at rest, pressures hydrostatic below
/// the column's surface. Air is left out where `with_air` is false.
Setup dam_break(const Model& model, Vec2 column, Vec2 tank, double particle_spacing, bool with_air = true);

/// State of each particle by its id, so that runs can be compared whatever the order in memory.
std::vector<FluidState> by_id(const FluidParticles& fluid);

/// Density rate, acceleration x and y of each particle by its id.
std::vector<std::array<double, 3>> rates_by_id(const FluidParticles& fluid);

/// Largest difference between the rates of two simulations of the same particles, over the largest of each
/// kind of rate and phase (those of air are a thousand times those of water).
double rate_difference(const Simulation& a, const Simulation& b);

/// Sets the environment variable WETDECK_SIMD for its own lifetime.
class ChosenInstructionSet {
  public:
    explicit ChosenInstructionSet(const std::string& name);
    ~ChosenInstructionSet();
    ChosenInstructionSet(const ChosenInstructionSet&) = delete;
    ChosenInstructionSet& operator=(const ChosenInstructionSet&) = delete;
};

/// Those of "sse2", "avx2", "avx512" that this processor has.
std::vector<std::string> instruction_sets();

}  // namespace wetdeck::samples
