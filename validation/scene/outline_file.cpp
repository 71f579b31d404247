// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/outline_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "solver/core/errors.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {
namespace {

constexpr std::size_t most_corners = 10'000;

/// The two numbers of a line; nothing if it holds anything else.
std::optional<Vec2> corner_in(const std::string& line) {
    const char* const begin = line.c_str();
    char *first_end = nullptr, *second_end = nullptr;
    const double x = std::strtod(begin, &first_end);
    char* second = first_end;
    while (*second == ' ' || *second == '\t') ++second;
    if (*second == ',' || *second == ';') ++second;
    const double y = std::strtod(second, &second_end);
    const bool two = first_end != begin && second != first_end && second_end != second;
    if (!two || *second_end != '\0' || !std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    return Vec2(x, y);
}

}  // namespace

Outline read_outline(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        throw InputError(fmt::format("{}: no such file of corners", file.string()));
    std::ifstream in(file);
    if (!in) throw EnvironmentError(fmt::format("{}: cannot be read", file.string()));
    Outline outline;
    bool names_passed = false;
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (line.empty() || line.front() == '#') continue;
        const std::optional<Vec2> corner = corner_in(line);
        const auto fail = [&](const std::string& message) {
            throw InputError(fmt::format("{}:{}: {}", file.string(), number, message));
        };
        if (!corner && outline.empty() && !names_passed) {
            names_passed = true;
            continue;
        }
        if (!corner) fail("expected two numbers, x and y [m]");
        if (!outline.empty() && *corner == outline.back()) fail("is the same corner as the one before");
        if (outline.size() == most_corners) fail(fmt::format("more than {} corners", most_corners));
        outline.push_back(*corner);
    }
    if (outline.size() > 1 && outline.back() == outline.front()) outline.pop_back();
    if (outline.size() < 3)
        throw InputError(fmt::format("{}: holds {} corners, expected at least 3 lines of x, y [m]",
                                     file.string(), outline.size()));
    return outline;
}

std::string with_outlines(std::string text, const std::filesystem::path& scene) {
    const auto files = TomlDocument(text, scene.string()).texts_named("outline");
    for (auto file = files.rbegin(); file != files.rend(); ++file) {  // from the end: places before it stay
        std::string corners;
        try {
            for (const Vec2& corner : read_outline(scene.parent_path() / file->value))
                corners += fmt::format("{}[{}, {}]", corners.empty() ? "" : ", ", corner.x(), corner.y());
        } catch (const InputError& error) {
            throw InputError(
                fmt::format("{}:{}: key '{}': {}", scene.string(), file->line, file->key, error.what()));
        }
        text.replace(file->begin, file->end - file->begin, "[" + corners + "]");
    }
    return text;
}

}  // namespace wetdeck
