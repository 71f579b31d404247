// SPDX-License-Identifier: BSD-3-Clause
// What the parts of a generated scene file are made of.
#pragma once

#include <filesystem>
#include <string>

#include "validation/generate/choices.hpp"

namespace wetdeck {

/// All that the parts of the file are made of.
struct SceneParts {
    const HullSection& section;
    const EntryWishes& wishes;
    const EntryChoices& c;
    std::filesystem::path file;

    std::string name() const { return file.stem().string(); }
    bool falls() const { return wishes.mass > 0; }
    std::string variant() const { return wishes.air ? "two-phase" : "water"; }
};

/// Ten digits at most.
std::string number_text(double value);
/// A text of TOML.
std::string quoted(const std::string& text);
/// Lines of a comment, as wide as the other texts of scenes.
std::string comment(const std::string& text);

/// Probes, quantities, and a comparison to fill in.
std::string analysis_text(const SceneParts& parts);

}  // namespace wetdeck
