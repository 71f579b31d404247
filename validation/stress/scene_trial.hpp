// SPDX-License-Identifier: BSD-3-Clause
// Hard cases that are scenes: one that comes with the program, changed, or a body of any outline over a
// basin.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "validation/stress/trial.hpp"

namespace wetdeck::stress {

using Change = std::function<void(Model&)>;

struct SceneCase {
    std::string scene, variant;
    double particle_spacing = 0, end = 0;     ///< [m], [s]
    std::vector<std::string> overrides = {};  ///< KEY=VALUE
};

/// @param change  of the model, after the scheme's ingredients
Trial trial_of(const SceneCase& scene, const Scheme& scheme, const Change& change = {});

/// The dam break of the shipped scene until T = 4.9, twice the time of the first impact, in a tank that all
/// spacings 0.6 m / n fit.
SceneCase dam_break(double particle_spacing = 0.06);

/// The shipped scenes with bodies, past what is hard in them: the plate until 5 ms after its contact, the
/// catamaran until 10 ms after that of its walls (the cushion has peaked and leaks), the rectangle to its
/// end. Plate and walls are as thick as shipped or, if that is more, as the kernel's support, which a body
/// has to be.
SceneCase flat_plate(double particle_spacing = 0.1 / 16);
SceneCase catamaran(double particle_spacing = 0.08 / 12);
SceneCase sinking_rectangle(double particle_spacing = 1.0 / 16);

/// A body that enters still water under air. Lengths [m], speeds [m/s], SI throughout.
struct Entry {
    std::vector<std::array<double, 2>> outline;  ///< corners about its lowest point
    double speed = 6.15;                         ///< downwards
    double mass = 0;                             ///< per metre, free to move along y; 0: keeps its speed
    double gap = 0.02;                           ///< between the lowest point and the water
    double particle_spacing = 0.02;
    double depth = 1;
    std::array<double, 2> tank = {2.4, 1.4};
    double sound_speed = 120;
    double background_pressure = 1500;
    double travel = 0.155;  ///< of an undelayed body until the end
    bool graded = false;    ///< particles grow away from the body, up to eight times the finest

    /// The pressures that an entry makes scale with the square of its speed, and the water's stiffness and
    /// the background pressure with them.
    void scale_to(double new_speed);
};

/// A wedge or, without deadrise, a box, half a metre wide with sides of 0.16 m.
Entry wedge_entry(double deadrise_degrees);

Trial trial_of(const Entry& entry, const Scheme& scheme, const Change& change = {});

}  // namespace wetdeck::stress
