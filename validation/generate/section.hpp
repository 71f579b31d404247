// SPDX-License-Identifier: BSD-3-Clause
// A section of a hull as `wetdeck new` reads it from a file of corners.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "solver/core/vec2.hpp"
#include "solver/setup/body_outline.hpp"

namespace wetdeck {

/// A section, and what its shape decides of a scene.
struct HullSection {
    std::filesystem::path file;
    bool mirrored = false;           ///< the file holds one half
    Outline outline;                 ///< whole, in the frame of the file [m]
    Box extent;                      ///< of the outline [m]
    Vec2 keel = Vec2::Zero();        ///< the first of the lowest corners [m]
    std::optional<double> deadrise;  ///< of the flattest side that counts, flat ones aside [rad]
    bool flat = false;               ///< a side of the bottom is flat
    double bottom_rise = 0;          ///< from the keel to the end of the bottom [m]

    double beam() const { return extent.high.x() - extent.low.x(); }
    double height() const { return extent.high.y() - extent.low.y(); }
};

/// The section in a file of corners (validation/scene/outline_file.hpp). The bottom ends where its sides
/// become steeper than 45 degrees, or where the section is widest if they all are.
/// @param half  whether the corners are one half of the section, to be mirrored; if absent: a file all of
///              whose corners lie at x >= 0 and that begins or ends with the keel on the axis is a half where
///              its other end is off the axis
///
/// Throws InputError where the file is no section, where it may be either, and where a section is wider than
/// a ship: its unit is missing.
HullSection read_section(const std::filesystem::path& file, std::optional<bool> half);

/// Whether every part is thick enough for boundary particles at this spacing, with a third to spare.
bool thick_enough(const HullSection& section, double particle_spacing);

}  // namespace wetdeck
