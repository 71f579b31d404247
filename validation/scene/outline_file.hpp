// SPDX-License-Identifier: BSD-3-Clause
// Outlines of bodies from files of corners: outline = "hull.csv".
#pragma once

#include <filesystem>
#include <string>

#include "solver/setup/body_outline.hpp"

namespace wetdeck {

/// Corners of a closed polygon: two numbers a line, x and y [m], with a comma, semicolon or space between
/// them. Lines that begin with '#', empty ones and one line of names in front of the first corner are passed
/// over; a last corner that is the first one again is left out. Throws InputError "file:line: what was
/// expected".
Outline read_outline(const std::filesystem::path& file);

/// The text of a scene file with the corners in place of each `outline` that names a file, whose path begins
/// at the folder of the scene. Lines keep their numbers, and the text needs the file no more.
std::string with_outlines(std::string text, const std::filesystem::path& scene);

}  // namespace wetdeck
