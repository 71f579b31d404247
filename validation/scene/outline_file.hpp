// SPDX-License-Identifier: BSD-3-Clause
// Outlines of bodies from files of corners, outline = "hull.csv", and from one half.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/setup/body_outline.hpp"

namespace wetdeck {

/// Corners of a closed polygon: two numbers a line, x and y, with commas, semicolons, spaces or tabs between
/// them, the same in every line. Comments from '#' on, empty lines and separators at the end of a line are
/// passed over, and so is one line of names in front of the first corner and one of units; a line that begins
/// with a number is a corner. Units in brackets, "x [mm], y [mm]", are lengths and converted; without any the
/// numbers are metres. A last corner that is the first one again is left out. Throws InputError "file:line:
/// what was expected", EnvironmentError where the file may not be read.
///
/// A section of a GHS geometry file, a drawing or a table of offsets is asked for as
/// "hull.gf#station=-12.3&part=1" (validation/sections/section_address.hpp).
Outline read_outline(const std::filesystem::path& file);
/// The same of a text; `name` stands in messages.
Outline parse_outline(const std::string& name, std::string_view text);

/// A section of which the half at x >= 0 is given, from the keel to the deck or back, with its mirror image.
/// A straight deck joins the upper ends. Throws InputError where a corner has x < 0, and where the lower end
/// is off the axis x = 0: a flat bottom would join the halves there.
Outline mirrored_section(Outline half);

/// The text of a scene file with the corners in place of each `outline` that names a file, whose path begins
/// at the folder of the scene. Lines keep their numbers, and the text needs the file no more: the lines of a
/// file of sections that the corners come from follow as a comment at the end of the line.
std::string with_outlines(std::string text, const std::filesystem::path& scene);

}  // namespace wetdeck
