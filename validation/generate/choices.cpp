// SPDX-License-Identifier: BSD-3-Clause
#include "validation/generate/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"
#include "validation/analytic/wagner.hpp"
#include "validation/scene/slamming.hpp"

namespace wetdeck {
namespace {

constexpr double gravity = 9.81;     // [m/s^2]
constexpr double density = 1000;     // of water [kg/m^3]
constexpr double real_sound = 1450;  // of water [m/s]

/// The next number of two digits, 1, 1.2, 1.5, ... times a power of ten, at or below.
double round_down(double value) {
    const double decade = std::pow(10, std::floor(std::log10(value) + 1e-9));
    double nice = 1;
    for (const double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (step * decade <= value * (1 + 1e-9)) nice = step;
    return nice * decade;
}

double multiple_above(double value, double unit) {
    return unit * std::ceil(value / unit - 1e-9);
}

void choose_sound(const HullSection& section, const EntryWishes& wishes, EntryChoices& all) {
    const double v = wishes.speed;
    double speed = 10 * v;
    all.sound_rule = SoundRule::fastest_speed;
    const auto at_least = [&](double asked, SoundRule rule) {
        if (asked <= speed) return;
        speed = asked;
        all.sound_rule = rule;
    };
    if (section.deadrise)
        at_least(sound_over_contact_line * v * wagner_contact_line_speed(*section.deadrise),
                 SoundRule::contact_line);
    if (section.flat) at_least(100 * v, SoundRule::flat_bottom);
    all.sound_speed = multiple_above(speed, speed > 100 ? 10 : 1);
    if (all.sound_speed <= real_sound) return;
    all.sound_speed = real_sound;
    all.sound_rule = SoundRule::real_water;
}

void choose_spacing(const HullSection& section, EntryChoices& all) {
    const double coarsest_sensible = round_down(section.beam() / 100);
    all.unit = coarsest_sensible;
    const auto serves = [&](double unit) {
        const double coarsest = 4 * unit;
        return thick_enough(section, coarsest) && thick_enough(section, unit);
    };
    while (!serves(all.unit)) {
        all.unit = round_down(0.9 * all.unit);
        all.thin = true;
        if (all.unit < coarsest_sensible / 12)
            throw InputError(
                fmt::format("{}: a part of the section is thinner than {:.3g} m, a {:.0f}th of the beam: "
                            "expected it thicker, or without that part",
                            section.file.string(), 16 * all.unit, section.beam() / (16 * all.unit)));
    }
}

void choose_record(const HullSection& section, const EntryWishes& wishes, EntryChoices& all) {
    const auto at_most = [&](double longest, RecordRule rule) {
        if (longest >= all.record) return;
        all.record = longest;
        all.record_rule = rule;
    };
    all.record = wishes.record.value_or(section.bottom_rise / wishes.speed);
    all.record_rule = wishes.record ? RecordRule::asked : RecordRule::bottom;
    if (!wishes.record) at_most(20 * section.beam() / all.sound_speed, RecordRule::cost);
    if (!wishes.depth) return;
    const double wanted = all.way() / 2;
    at_most(2 * *wishes.depth / (sound_margin * all.sound_speed), RecordRule::depth);
    const double least = wishes.record ? 1 : 0.25;  // of the depth wanted
    if (*wishes.depth < least * wanted)
        throw InputError(fmt::format(
            "--depth is {:.4g} m: at {:.4g} m/s sound is back from the floor after {:.3g} ms, before the "
            "record of {:.3g} ms is over; expected at least {:.3g} m{}",
            *wishes.depth, all.sound_speed, 2000 * *wishes.depth / all.sound_speed,
            2000 * wanted / sound_margin / all.sound_speed, least * wanted,
            wishes.record ? ", or a shorter --record" : ""));
}

/// Sides of the water in multiples of twelve units, which all three spacings divide.
void choose_tank(const HullSection& section, const EntryWishes& wishes, EntryChoices& all) {
    const double beam = section.beam();
    const double deep = std::max(all.way() / 2, 2 * beam);
    if (wishes.depth && *wishes.depth < deep) {  // the user's own depth to the digit: the spacing fits it
        all.depth = *wishes.depth;
        all.unit = all.depth / 12 / std::ceil(all.depth / 12 / all.unit - 1e-9);
    }
    const double cell = 12 * all.unit;
    if (all.depth == 0) all.depth = multiple_above(deep, cell);
    const double middle = 0.5 * (section.extent.low.x() + section.extent.high.x());
    const double beside = std::abs(section.keel.x() - middle);
    all.width = multiple_above(std::max(all.way() + 0.5 * beam + beside, 4 * beam), cell);
}

void choose_start(const HullSection& section, const EntryWishes& wishes, EntryChoices& all) {
    all.gap = 2 * all.spacings().front();
    all.start_speed = wishes.speed;
    if (wishes.mass > 0) {
        all.gap = std::min(all.gap, 0.5 * wishes.speed * wishes.speed / gravity);
        all.start_speed = std::sqrt(std::max(0.0, wishes.speed * wishes.speed - 2 * gravity * all.gap));
    }
    all.contact = 2 * all.gap / (wishes.speed + all.start_speed);
    const double above = all.gap + section.height() + (wishes.air ? 0.5 * section.beam() : all.gap);
    all.headroom = multiple_above(above, 12 * all.unit);
}

void choose_times(const EntryWishes& wishes, EntryChoices& all) {
    all.sample = round_down(all.record / 200);
    all.end = multiple_above(all.contact + all.record, all.sample);
    if (wishes.air)
        all.background_pressure =
            round_down(std::clamp(0.05 * 0.5 * density * wishes.speed * wishes.speed, 100.0, 1500.0));
}

}  // namespace

EntryChoices choose(const HullSection& section, const EntryWishes& wishes) {
    EntryChoices all;
    choose_sound(section, wishes, all);
    choose_record(section, wishes, all);
    choose_spacing(section, all);
    choose_tank(section, wishes, all);
    choose_start(section, wishes, all);
    choose_times(wishes, all);
    return all;
}

}  // namespace wetdeck
