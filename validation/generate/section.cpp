// SPDX-License-Identifier: BSD-3-Clause
#include "validation/generate/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "solver/core/errors.hpp"
#include "solver/physics/model.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/scene/bottom.hpp"
#include "validation/scene/faces.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/sections/section_address.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

constexpr double on_axis = 1e-9;     // [m]
constexpr double widest_ship = 100;  // [m]

/// The end of the corners that is the keel of a half section, and the other one.
struct Ends {
    Vec2 keel, deck;
};

/// None where the corners cannot be one half.
std::optional<Ends> ends_of_half(const Outline& corners) {
    Ends ends{corners.front(), corners.back()};
    if (ends.deck.y() < ends.keel.y()) std::swap(ends.keel, ends.deck);
    if (std::abs(ends.keel.x()) > on_axis) return std::nullopt;
    for (const Vec2& corner : corners)
        if (corner.x() < -on_axis || corner.y() < ends.keel.y()) return std::nullopt;
    return ends;
}

bool is_half(const Outline& corners, const std::string& file) {
    const std::optional<Ends> ends = ends_of_half(corners);
    if (!ends) return false;
    if (ends->deck.x() > on_axis) return true;
    throw InputError(
        fmt::format("{}: begins and ends on the axis x = 0 with all corners on one side: expected --half "
                    "(mirror it) or --whole (as it is)",
                    file));
}

double rise_of_bottom(const HullSection& section) {
    constexpr double steep = std::numbers::pi / 4;
    double top = section.extent.low.y();
    bool flat_end = false;
    for (const BottomSide& side : bottom_sides(section.outline)) {
        if (side.deadrise >= steep || side.share_of_beam < least_share_of_beam || side.top < top) continue;
        top = side.top;
        flat_end = side.deadrise < flattest_deadrise_of_wedge;
    }
    const double share_of_beam = flat_end ? 0.1 : 0;  // a flat side is to sink, too
    if (top > section.extent.low.y() || flat_end)
        return top - section.extent.low.y() + share_of_beam * section.beam();
    double widest = section.extent.high.y();
    for (const Vec2& corner : section.outline)
        if (section.extent.high.x() - corner.x() < on_axis) widest = std::min(widest, corner.y());
    return std::max(widest - section.extent.low.y(), 0.1 * section.beam());
}

Outline checked(const Outline& corners, bool half, const std::string& file) {
    try {
        const Outline whole = half ? mirrored_section(corners) : corners;
        check_outline(whole);
        return whole;
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: the outline {}", file, error.what()));
    }
}

}  // namespace

HullSection read_section(const std::filesystem::path& file, std::optional<bool> half) {
    const std::string name = file.string();
    if (!section_address(name) && std::filesystem::is_regular_file(file) &&
        looks_like_reference(read_whole_file(file)))
        throw InputError(fmt::format(
            "{}: is a curve with a header or more than two columns, expected the corners x, y", name));
    const Outline corners = read_outline(file);
    HullSection section;
    section.file = file;
    section.mirrored = half ? *half : is_half(corners, name);
    section.outline = checked(corners, section.mirrored, name);
    section.extent = extent_of(section.outline);
    if (section.beam() > widest_ship)
        throw InputError(
            fmt::format("{}: the section is {:.4g} m wide: expected its unit in the first line, "
                        "as in 'x [mm], y [mm]'",
                        name, section.beam()));
    section.keel = *std::min_element(section.outline.begin(), section.outline.end(),
                                     [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    section.deadrise = flattest_deadrise(section.outline);
    section.flat = has_flat_bottom(section.outline);
    section.bottom_rise = rise_of_bottom(section);
    return section;
}

bool thick_enough(const HullSection& section, double particle_spacing) {
    const double spacing = particle_spacing * 4 / 3;
    try {
        WallParticles walls;
        add_body_particles(walls, 0, section.outline, Vec2::Zero(), spacing,
                           2 * Model{}.smoothing_ratio * spacing);
    } catch (const InputError&) {
        return false;
    }
    return true;
}

}  // namespace wetdeck
