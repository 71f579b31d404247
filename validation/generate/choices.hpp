// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a scene for the water entry of a section, by stated rules.
//
// With V the speed at the water, B the beam, b the least deadrise, c the sound speed, T the time from
// contact:
//     c        12 pi V/(2 tan b) for a bottom of wedges (validation/scene/slamming.hpp), 100 V where a
//              side is flat, at least 10 V, at most that of real water, 1450 m/s
//     T        until the level at rest reaches the end of the bottom at the speed V, at most 20 B/c
//     tank     1.05 c T of way there and back for sound, to the floor and to the sides
//     spacing  50 on the beam, or finer, so that every part is four of the coarsest spacings thick
//     start    two of the coarsest spacings above the water
//     p0       with air 5 % of rho V^2/2, 100 to 1500 Pa; without air none
#pragma once

#include <array>
#include <optional>

#include "validation/generate/section.hpp"

namespace wetdeck {

/// What the tank leaves to sound over what the record needs.
inline constexpr double sound_margin = 1.05;

/// What the user asks for.
struct EntryWishes {
    double speed = 0;              ///< downwards, where the keel meets the water [m/s]
    double mass = 0;               ///< per metre of span [kg/m]; 0: the speed is kept
    std::optional<double> depth;   ///< of the water [m]; absent: deep
    bool air = false;              ///< water and air, not water alone
    std::optional<double> record;  ///< time from contact to the end [s]; absent: by the rule
};

/// What decided a number.
enum class SoundRule { contact_line, flat_bottom, fastest_speed, real_water };
enum class RecordRule { bottom, cost, depth, asked };

struct EntryChoices {
    double sound_speed = 0;  ///< [m/s]
    SoundRule sound_rule = SoundRule::contact_line;
    double record = 0;  ///< from contact to the end [s]
    RecordRule record_rule = RecordRule::bottom;
    double unit = 0;  ///< of lengths: the spacings are 4, 3 and 2 of it, the tank's sides multiples of 12 [m]
    bool thin = false;               ///< the thinnest part decided the spacing, not the beam
    double width = 0;                ///< of the tank [m]
    double depth = 0;                ///< of the water [m]
    double headroom = 0;             ///< above the water [m]
    double gap = 0;                  ///< of the keel above the water at the start [m]
    double start_speed = 0;          ///< downwards [m/s]
    double contact = 0;              ///< when the keel meets the water [s]
    double end = 0;                  ///< of the run [s]
    double sample = 0;               ///< interval of the samples [s]
    double background_pressure = 0;  ///< [Pa]

    std::array<double, 3> spacings() const { return {4 * unit, 3 * unit, 2 * unit}; }
    /// Way of sound that the tank leaves, there and back [m].
    double way() const { return sound_margin * sound_speed * record; }
};

/// Throws InputError, with the flag to change, where no set-up serves: water so shallow that sound is back
/// from the floor too soon, a part too thin for any spacing of reasonable cost.
EntryChoices choose(const HullSection& section, const EntryWishes& wishes);

}  // namespace wetdeck
