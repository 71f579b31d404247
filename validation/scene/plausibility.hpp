// SPDX-License-Identifier: BSD-3-Clause
// What a scene may mean, but what is more often a slip: of a unit, a sign, a place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// One line for each of these:
/// - the water's sound speed is below ten times the fastest speed to expect (expected_motion.hpp): it is
///   compressed by more than 1 %;
/// - water that falls on air which it encloses (trapped_air.hpp);
/// - a sound speed or a tank too small for slamming (slamming.hpp);
/// - gravity points up or sideways, is tilted or larger than 20 m/s^2; water that is lighter than air;
/// - a part of the tank that neither water nor air nor a body fills, in a scene with air;
/// - initial.surface is not the top of any water; a column for the pressure of Greco that is higher than
/// wide;
/// - a body that can move is more than 30 times heavier or 60 times lighter than the water it would displace,
///   or its inertia is beyond ten times or below a tenth of that of even density;
/// - a motion that is given leads a body out of the tank;
/// - fewer than fifty samples, or frames after the end;
/// - windows and instants that the run does not reach, plain scales of two dimensions (asked_axes.hpp);
/// - a density in t/m^3, a sound speed beyond 2000 m/s, a Courant number beyond 0.8;
/// - an outline that looks like a half section;
/// - the doubts of its probes;
/// - a background pressure above half of the air's own stiffness;
/// - values that nothing uses (unused_values.hpp).
std::vector<std::string> doubtful(const Scene& scene);

/// A sentence where the scene's fixed time step exceeds the criteria of Eq. (26) at this spacing [m], even
/// for fluid at rest, and for each body that starts in the water less than two spacings from the tank or
/// another body: so thin a layer of particles carries a part of the pressure only.
std::vector<std::string> doubts_at_spacing(const Scene& scene, double particle_spacing);

/// All doubts about one run: of the scene, and of this spacing [m].
/// @param until  where the run ends instead of at the scene's end [s]; an earlier end raises no doubt
std::vector<std::string> doubts_of_run(const Scene& scene, double particle_spacing,
                                       std::optional<double> until = std::nullopt);

/// What is in order, but good to know: a body starts in the water, or has a flat bottom.
std::vector<std::string> remarks(const Scene& scene);

}  // namespace wetdeck
