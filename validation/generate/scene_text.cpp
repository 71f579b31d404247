// SPDX-License-Identifier: BSD-3-Clause
#include "validation/generate/scene_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "validation/analytic/wagner.hpp"
#include "validation/generate/scene_parts.hpp"
#include "validation/scene/bottom.hpp"
#include "validation/scene/slamming.hpp"

namespace wetdeck {
namespace {

double degrees(double angle) {
    return angle * 180 / std::numbers::pi;
}

std::string head(const SceneParts& p) {
    const std::string motion =
        p.falls() ? fmt::format("{} kg/m, falling freely", number_text(p.wishes.mass)) : "at constant speed";
    return comment(fmt::format(
               "Water entry of the section in {}, written by `wetdeck new`. SI units; lengths from the lower "
               "left corner of the tank. Every number may be changed: `wetdeck check` says what no longer "
               "fits.",
               p.section.file.filename().string())) +
           fmt::format(
               R"(schema = 1
name = {}
title = {}
purpose = {}
source = "own section"
gravity = [0.0, -9.81]
default_variant = "{}"
limits = ["Two-dimensional{}"]

)",
               quoted(p.name()),
               quoted(fmt::format("Water entry of {} at {} m/s", p.name(), number_text(p.wishes.speed))),
               quoted(fmt::format("Slamming of a section of {:.4g} m beam, {}.", p.section.beam(), motion)),
               p.variant(), p.wishes.air ? "." : ", and without air.");
}

std::string reason_of_depth(const SceneParts& p) {
    if (p.wishes.depth && std::abs(*p.wishes.depth - p.c.depth) < 1e-9) return "the depth asked for";
    const std::string cut = p.wishes.depth
                                ? fmt::format(" (asked for: {} m; deeper water changes nothing by then)",
                                              number_text(*p.wishes.depth))
                                : "";
    return fmt::format("sound is not back from the floor before the end{}", cut);
}

std::string tank(const SceneParts& p) {
    const EntryChoices& c = p.c;
    return comment(fmt::format(
               "The tank: within the record of {:.4g} ms sound at {} m/s goes {:.3g} m, 5 % to spare. From "
               "the section to the sides and back is longer{}. Sides are multiples of {} m, which all "
               "spacings divide.",
               1000 * c.record, number_text(c.sound_speed), c.way(),
               c.record_rule == RecordRule::depth ? ", to the floor and back as long"
                                                  : ", to the floor and back too",
               number_text(12 * c.unit))) +
           fmt::format(R"([tank]
size = [{}, {}]

[initial]
pressure = "hydrostatic"
surface = {}   # {}

)",
                       number_text(c.width), number_text(c.depth + c.headroom), number_text(c.depth),
                       reason_of_depth(p));
}

std::string reason_of_sound(const SceneParts& p) {
    const double v = p.wishes.speed;
    std::string on_side;
    if (p.section.deadrise)
        on_side = fmt::format(
            "on the flattest side, {:.3g} degrees, the contact line moves at pi V/(2 tan b) = "
            "{:.3g} m/s",
            degrees(*p.section.deadrise), v * wagner_contact_line_speed(*p.section.deadrise));
    switch (p.c.sound_rule) {
        case SoundRule::contact_line:
            return on_side +
                   ". Twelve times that keeps slamming forces within 2 % of those of incompressible water.";
        case SoundRule::flat_bottom:
            return "a side of the bottom is flat and meets the water at once, with the pressure rho c V. A "
                   "hundred times the speed keeps the compression of the water, V/c, to 1 %. That first "
                   "pressure follows the sound speed, impulses do not: compare it only at the same sound "
                   "speed.";
        case SoundRule::fastest_speed:
            return "ten times the fastest speed, so that the density changes by 1 % or less.";
        case SoundRule::real_water:
            break;
    }
    return "that of real water; " + (on_side.empty() ? "a flat bottom at this speed asks for more."
                                                     : on_side + ", and twelve times that would be more.");
}

std::string water(const SceneParts& p) {
    const EntryChoices& c = p.c;
    const std::string text =
        comment("The sound speed sets the time step, and with it the cost: " + reason_of_sound(p)) +
        fmt::format(R"([water]
density = 1000.0   # fresh; 1025 in the sea
sound_speed = {}
exponent = 7.0
boxes = [[0.0, 0.0, {}, {}]]

)",
                    number_text(c.sound_speed), number_text(c.width), number_text(c.depth));
    if (c.sound_rule != SoundRule::real_water) return text;
    return text + "[accepted_doubts]\nsound_speed = \"it is that of real water\"\n\n";
}

std::string air(const SceneParts& p) {
    const EntryChoices& c = p.c;
    if (!p.wishes.air)
        return "[model]\nair = false\nbackground_pressure = 0.0   # water alone takes none\n\n";
    return fmt::format(R"([air]
density = 1.2
exponent = 1.4
law = "physical"
boxes = [[0.0, {}, {}, {}]]

)",
                       number_text(c.depth), number_text(c.width), number_text(c.depth + c.headroom)) +
           comment(
               "The background pressure keeps water from tearing where the pressure sinks, and softens a "
               "slam a little: 5 % of rho V^2/2, from 100 to 1500 Pa.") +
           fmt::format("[model]\nair = true\nbackground_pressure = {}\n\n",
                       number_text(c.background_pressure));
}

std::string outline_key(const SceneParts& p) {
    const std::filesystem::path folder = std::filesystem::absolute(p.file).lexically_normal().parent_path();
    const std::filesystem::path outline = std::filesystem::absolute(p.section.file).lexically_normal();
    const std::filesystem::path relative = outline.lexically_relative(folder);
    return quoted((relative.empty() ? outline : relative).string());
}

std::string body(const SceneParts& p) {
    const EntryChoices& c = p.c;
    const Box& extent = p.section.extent;
    const double x = 0.5 * c.width - 0.5 * (extent.low.x() + extent.high.x());
    const double y = c.depth + c.gap - extent.low.y();
    const bool from_rest = c.start_speed == 0;
    const std::string motion = p.falls()
                                   ? fmt::format("free = [\"y\"]\nmass = {}   # per metre of span [kg/m]\n",
                                                 number_text(p.wishes.mass))
                                   : "free = []\n";
    const std::string speed = p.falls() ? fmt::format("{} m/s at the water, after {:.4g} m of fall",
                                                      number_text(p.wishes.speed), c.gap)
                                        : "kept throughout";
    return comment(fmt::format("The section starts with its keel {:.4g} m above the water{}.", c.gap,
                               from_rest ? ", from rest" : ", two of the coarsest spacings")) +
           fmt::format("[body]\noutline = {}\n{}position = [{}, {}]   # of the point (0, 0) of the outline\n",
                       outline_key(p), p.section.mirrored ? "mirrored = true\n" : "", number_text(x),
                       number_text(y)) +
           motion + fmt::format("velocity_y = {}   # {}\n\n", number_text(0 - c.start_speed), speed);
}

std::string reason_of_record(const SceneParts& p) {
    switch (p.c.record_rule) {
        case RecordRule::bottom:
            return fmt::format(
                "until the level at rest reaches the end of the bottom, {:.4g} m above the keel",
                p.section.bottom_rise);
        case RecordRule::cost:
            return "as long as a tank of 20 beams allows; a longer one by --record";
        case RecordRule::depth:
            return "until sound is back from the floor, at the depth asked for";
        case RecordRule::asked:
            break;
    }
    return "as asked for";
}

std::string run(const SceneParts& p) {
    const EntryChoices& c = p.c;
    std::string frames;
    for (const double share : {0.25, 0.5, 0.75, 1.0})
        frames += (frames.empty() ? "" : ", ") + fmt::format("{:.4g}", c.contact + 0.999 * share * c.record);
    return comment(fmt::format(
               "The record is {:.4g} ms from contact, which is at {:.4g} ms: {}. It has 200 samples or "
               "more; the filtered forces and accelerations are moving means of five.",
               1000 * c.record, 1000 * c.contact, reason_of_record(p))) +
           fmt::format(R"([run]
end_time = {}
sample_interval = {}
force_filter = {}
frames = [{}]
frame_interval = {}

)",
                       number_text(c.end), number_text(c.sample), number_text(5 * c.sample), frames,
                       number_text(10 * c.sample));
}

std::string tiers(const SceneParts& p) {
    const auto [coarse, middle, fine] = p.c.spacings();
    const std::string reason =
        p.c.thin ? "every part of the section is at least four of the coarsest thick, as walls need."
                 : fmt::format("the finest of the quick tier divides the beam {:.0f} times.",
                               p.section.beam() / fine);
    const std::string finer = fmt::format("{{ {} = [{}, {}, {}] }}", p.variant(), number_text(coarse),
                                          number_text(fine), number_text(p.c.unit));
    return comment("Spacings, three for the convergence of each quantity: " + reason) +
           fmt::format("[tiers]\nquick = {{ {} = [{}, {}, {}] }}\nstandard = {}\npaper = {}\n\n", p.variant(),
                       number_text(coarse), number_text(middle), number_text(fine), finer, finer);
}

std::string variants(const SceneParts& p) {
    const std::string late = p.section.flat && p.wishes.air
                                 ? " Under a flat bottom the air is pressed out late: what it does before "
                                   "contact has negative times."
                                 : "";
    return fmt::format("[variants.{}]\ndescription = {}\n\n", p.variant(),
                       p.wishes.air ? "\"water and air\"" : "\"water alone\"") +
           comment("Each run finds when the keel meets the level." + late) +
           "[time_origins]\ncontact = \"geometric_contact\"\n\n[scales]\nmillisecond = 0.001\n\n";
}

}  // namespace

std::string scene_text(const HullSection& section, const EntryWishes& wishes, const EntryChoices& choices,
                       const std::filesystem::path& file) {
    const SceneParts p{section, wishes, choices, file};
    return head(p) + tank(p) + water(p) + air(p) + body(p) + run(p) + tiers(p) + variants(p) +
           analysis_text(p);
}

}  // namespace wetdeck
