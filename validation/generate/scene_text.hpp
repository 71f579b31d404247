// SPDX-License-Identifier: BSD-3-Clause
// The scene file of a section's water entry, with the reason of each choice beside it.
#pragma once

#include <filesystem>
#include <string>

#include "validation/generate/choices.hpp"

namespace wetdeck {

/// @param file  where the scene will lie: its stem is the scene's name, and the path of the outline begins at
///              its folder
std::string scene_text(const HullSection& section, const EntryWishes& wishes, const EntryChoices& choices,
                       const std::filesystem::path& file);

}  // namespace wetdeck
