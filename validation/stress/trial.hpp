// SPDX-License-Identifier: BSD-3-Clause
// One run of a hard case: whether it reaches its end, how accurate it was until then, and where it became
// unstable.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "solver/simulation.hpp"
#include "validation/store/fields.hpp"

namespace wetdeck::stress {

/// A scheme by its name (validation/schemes/NAME.toml); empty for the default scheme.
using Scheme = std::string;
inline const Scheme default_scheme;

/// A simulation ready to run. It ends at a time or after a number of steps, whichever comes first.
struct Trial {
    Simulation simulation;
    double end = std::numeric_limits<double>::infinity();  ///< [s]
    Simulation::StabilityMonitor watch = {};
    std::uint64_t most_steps = std::numeric_limits<std::uint64_t>::max();
};

/// The last good state of a run that became unstable, and where it did.
struct Failure {
    Instability instability;
    std::string surroundings;      ///< of the particle, in words
    FieldFrame frame;              ///< at most 16 steps earlier
    Vec2 position = Vec2::Zero();  ///< of the instability, in the frame [m]
    double particle_spacing = 0;
};

struct Outcome {
    std::optional<Failure> failure;
    std::uint64_t steps = 0;
    double density_error = 0;  ///< largest |rho/rho0 - 1| of the water until the end or the last good state
    double energy_gain = 0;    ///< largest gain of energy that no body did work for, over that of the start
    bool survived() const { return !failure; }
    std::string note() const;
};

Outcome run_trial(Trial trial);

/// A picture of 40 spacings around the instability.
std::vector<unsigned char> picture_of(const Failure& failure);

}  // namespace wetdeck::stress
