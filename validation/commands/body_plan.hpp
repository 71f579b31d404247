// SPDX-License-Identifier: BSD-3-Clause
// The body plan of a file of sections: stations aft of the middle on the left, forward ones on the right.
#pragma once

#include <vector>

#include "validation/commands/drawing.hpp"
#include "validation/sections/section_file.hpp"

namespace wetdeck {

/// A straight piece of a section's outline, with the row of the list that it belongs to.
struct PlanLine {
    Vec2 begin, end;  ///< [m]
    std::size_t row = 0;
};

/// What the plan shows. Of a drawing, all curves as they are drawn; else of each station one half.
std::vector<PlanLine> body_plan(const SectionFile& file);

/// The plan with heights, half breadths and the numbers of the rows.
Drawing drawn_body_plan(const SectionFile& file);

}  // namespace wetdeck
