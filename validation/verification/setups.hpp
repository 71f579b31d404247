// SPDX-License-Identifier: BSD-3-Clause
// Models, set-ups and measures that several problems share.
#pragma once

#include <cstdint>

#include "solver/core/dice.hpp"
#include "solver/setup/body_outline.hpp"
#include "solver/setup/graded_lattice.hpp"
#include "solver/simulation.hpp"

namespace wetdeck::verification {

inline constexpr double water_density = 1000, air_density = 1;  // [kg/m^3]

/// A wide smoothing length over the spacing, 1.8 times as many neighbours as usual. At the usual ratio the
/// sums over particles that have left the lattice miss a share of the pressure that no refinement makes
/// smaller.
inline constexpr double wide_smoothing_ratio = 2;

/// Water alone, the scheme's defaults, one thread. Negative pressure is allowed.
Model water_model(double sound_speed, double gravity = 0);

/// Water and air, the scheme's defaults, one thread.
Model two_phase_model(double water_sound_speed, double air_sound_speed, double background_pressure,
                      double gravity = 0);

/// All parts of a simulation, on one thread and with the instruction set that WETDECK_SIMD names.
struct Setup : SimulationSetup {
    /// A tank with walls all around; without them its sides are only where particles are expected.
    Setup(const Model& model, Box domain, double particle_spacing, bool with_walls = false);
    /// Adds a box of fluid at its reference density.
    void fill(Phase phase, Box box);
    /// Adds fluid between a box and the sides of the domain.
    void fill_around(Phase phase, Box box);
    /// Fills a tank with water up to a level, with spacings that grow as `grading` says, and gives it its
    /// walls. The rest of the tank is dry.
    void fill_graded(double level, const Grading& grading);
    /// Sets the water turning about the origin as a rigid body [1/s].
    void spin_water(double rotation);
    /// Puts a body where its position and angle say and takes away the fluid there. The outline is about its
    /// mass centre.
    void put(const RigidBody& body, const Outline& outline);
    Simulation simulate() const { return Simulation(*this); }
};

/// Moves every particle by up to `share` spacings along each axis.
void shake(Setup& setup, double share, std::uint64_t seed);

/// Kernel mean of a value over the fluid at a position: SUM value_j V_j W_j / SUM V_j W_j.
template <class Value>
double kernel_mean(const Simulation& simulation, Vec2 position, Value value) {
    const WendlandC2 kernel = simulation.kernel();
    const FluidParticles& fluid = simulation.fluid();
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        const double weight = p.volume * kernel.value((p.position() - position).norm());
        if (weight == 0) continue;
        sum += weight * value(i);
        weights += weight;
    }
    return sum / weights;
}

/// Root mean square of the values of f over the fluid's particles that `chosen` picks.
template <class Chosen, class Value>
double rms(const FluidParticles& fluid, Chosen chosen, Value value) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        if (!chosen(i)) continue;
        const double v = value(i);
        sum += v * v;
        count += 1;
    }
    return std::sqrt(sum / count);
}

}  // namespace wetdeck::verification
