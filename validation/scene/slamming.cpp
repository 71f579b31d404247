// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/slamming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "validation/analytic/wagner.hpp"
#include "validation/scene/asked_axes.hpp"
#include "validation/scene/bottom.hpp"
#include "validation/scene/expected_motion.hpp"
#include "validation/scene/faces.hpp"

namespace wetdeck {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Where sound comes back from, and when.
struct Echo {
    const char* from;
    double way;   ///< there and back [m]
    double time;  ///< on the clock of the run [s]
};

Echo first_echo(const Scene& scene, const BodySpec& spec, const WaterEntry& entry) {
    const Box extent = extent_of(spec.outline);
    const double depth = entry.level - scene.tank.low.y();
    const double x = entry.keel.x();
    // from the keel to the wall and back to the nearest point of the body
    const double by_left = (x - scene.tank.low.x()) + (extent.low.x() - scene.tank.low.x());
    const double by_right = (scene.tank.high.x() - x) + (scene.tank.high.x() - extent.high.x());
    const double by_side = std::min(by_left, by_right);
    const bool floor = 2 * depth <= by_side;
    const double way = floor ? 2 * depth : by_side;
    return {floor ? "the floor" : "the sides of the tank", way,
            entry.time + way / scene.model.water.eos.sound_speed};
}

/// Units of what an echo moves at once; velocities and positions feel its time integral.
bool feels_echo(const std::string& unit) {
    return unit == "N/m" || unit == "N" || unit == "Pa" || unit == "m/s^2" || unit == "rad/s^2";
}

std::optional<std::string> doubtful_echo(const Scene& scene, const BodySpec& spec) {
    constexpr double real_sound = 1000;  // [m/s]: beyond it, an echo is that of the tank
    const std::optional<WaterEntry> entry = water_entry(scene, spec);
    if (!entry || scene.model.water.eos.sound_speed > real_sound) return std::nullopt;
    const Echo echo = first_echo(scene, spec, *entry);
    std::vector<AskedTime> late;
    for (AskedTime& asked : asked_times(scene))
        if (feels_echo(asked.unit) && asked.last > (1 + 1e-6) * echo.time) late.push_back(std::move(asked));
    if (late.empty()) return std::nullopt;
    const auto latest = std::max_element(
        late.begin(), late.end(), [](const AskedTime& a, const AskedTime& b) { return a.last < b.last; });
    const std::string others = late.size() > 1 ? fmt::format(" and {} more", late.size() - 1) : "";
    return fmt::format(
        "sound is back at {} from {} {:.4g} s after it meets the water ({:.4g} m at {:.4g} m/s), at {:.4g} s "
        "on the clock of the run; later times, up to {:.4g} s, enter {}{}: expected a larger tank ({:.4g} m "
        "of "
        "way), an earlier end, or the reason as accepted_doubts.echo",
        spec.name, echo.from, echo.time - entry->time, echo.way, scene.model.water.eos.sound_speed, echo.time,
        latest->last, latest->name, others, (latest->last - entry->time) * scene.model.water.eos.sound_speed);
}

}  // namespace

std::optional<FastestContactLine> fastest_contact_line(const Scene& scene) {
    std::optional<FastestContactLine> fastest;
    for (const BodySpec& spec : scene.bodies) {
        const std::optional<WaterEntry> entry = water_entry(scene, spec);
        const std::optional<double> deadrise = flattest_deadrise(spec.outline);
        if (!entry || !deadrise) continue;
        const double speed = entry->speed * wagner_contact_line_speed(*deadrise);
        if (!fastest || speed > fastest->speed) fastest = {spec.name, entry->speed, *deadrise, speed};
    }
    return fastest;
}

std::vector<std::string> doubtful_impacts(const Scene& scene) {
    std::vector<std::string> found;
    const double sound = scene.model.water.eos.sound_speed;
    const std::optional<FastestContactLine> line = fastest_contact_line(scene);
    if (line && scene.accepted.sound_speed.empty() && sound < 0.95 * sound_over_contact_line * line->speed)
        found.push_back(fmt::format(
            "water.sound_speed is {:.4g} m/s: on the side of {:.3g} degrees of {}, which meets the water at "
            "{:.3g} m/s, the contact line moves at {:.3g} m/s (Wagner), and slamming forces come out too low "
            "by about {:.2g} %; expected at least {:.4g} m/s, or the reason as accepted_doubts.sound_speed",
            sound, line->deadrise / degree, line->body, line->entry_speed, line->speed,
            100 * loss_by_compressibility * line->speed * line->speed / (sound * sound),
            sound_over_contact_line * line->speed));
    if (!scene.accepted.echo.empty()) return found;
    for (const BodySpec& spec : scene.bodies)
        if (auto text = doubtful_echo(scene, spec)) found.push_back(std::move(*text));
    return found;
}

std::vector<std::string> impact_remarks(const Scene& scene) {
    std::vector<std::string> all;
    for (const BodySpec& spec : scene.bodies) {
        const std::optional<WaterEntry> entry = water_entry(scene, spec);
        const TaitEquationOfState& eos = scene.model.water.eos;
        if (entry && has_flat_bottom(spec.outline))
            all.push_back(
                fmt::format("{} has a flat bottom: its first pressure without air, rho c V = {:.3g} kPa, is "
                            "in proportion "
                            "to water.sound_speed",
                            spec.name, eos.reference_density * eos.sound_speed * entry->speed / 1000));
    }
    if (!scene.accepted.sound_speed.empty())
        all.push_back(fmt::format("the sound speed is accepted: {}", scene.accepted.sound_speed));
    if (!scene.accepted.echo.empty())
        all.push_back(fmt::format("the echo of the tank is accepted: {}", scene.accepted.echo));
    return all;
}

}  // namespace wetdeck
