// SPDX-License-Identifier: BSD-3-Clause
// Beam, depth, deadrise, half breadths and area of an outline.
#pragma once

#include <optional>

#include "validation/sections/section_file.hpp"

namespace wetdeck {

struct SectionFigures {
    double low = 0, high = 0;        ///< of the outline's corners, up [m]
    double beam = 0;                 ///< of a half, twice its largest half breadth [m]
    double area = 0;                 ///< of a half, of both [m^2]
    std::optional<double> deadrise;  ///< see below [rad]

    double depth() const { return high - low; }
};

/// The deadrise is that of the straight line from the keel (the lowest corner nearest to the centre line) to
/// the bottom at an eighth of the beam further out, to the side where the outline is wider; none where there
/// is no bottom.
SectionFigures figures_of(const SectionOutline& outline);

/// The largest distance from the centre line x = 0 at a height [m]; none above and below the outline.
std::optional<double> half_breadth_at(const SectionOutline& outline, double height);

/// The outline of both halves of an open half at x >= 0 or x <= 0; a closed one as it is.
Outline whole_outline(const SectionOutline& outline);

/// Whether an open outline is half a section: on one side of x = 0, and its lower end on it.
bool is_half_section(const SectionOutline& outline);

}  // namespace wetdeck
