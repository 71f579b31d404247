// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "validation/generate/scene_parts.hpp"

namespace wetdeck {
namespace {

/// A quantity of a series between contact and the end of the record.
std::string quantity(const char* name, const char* metric, const char* series, const char* unit) {
    return fmt::format(R"([[quantities]]
name = "{}"
metric = "{}"
series = "{}"
x_origin = "contact"
unit = "{}"

)",
                       name, metric, series, unit);
}

/// A gauge in the middle of the longest side of the bottom, if it has room for it.
std::string gauge(const SceneParts& p) {
    const Outline& outline = p.section.outline;
    const double top = p.section.extent.low.y() + p.section.bottom_rise;
    double longest = 0;
    Vec2 centre = Vec2::Zero();
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 &from = outline[k], &to = outline[(k + 1) % outline.size()];
        const Vec2 middle = 0.5 * (from + to);
        const bool faces_down = distance_to(outline, middle - Vec2(0, 1e-3 * p.c.unit)) > 0;
        if (!faces_down || middle.y() > top || (to - from).norm() < (1 - 1e-9) * longest) continue;
        if ((to - from).norm() < (1 + 1e-9) * longest && middle.x() < centre.x()) continue;
        longest = (to - from).norm();
        centre = middle;
    }
    const double diameter = 2 * p.c.spacings().front();
    if (longest < 1.5 * diameter) return "";
    return comment(
               "A pressure peak that runs past the gauge may be narrower than a coarse spacing, and feels "
               "the sound speed more than forces do: judge it by its convergence.") +
           fmt::format(R"([[probes]]
name = "pressure_bottom"
type = "body_pressure"
centre = [{:.17g}, {:.17g}]   # middle of the longest side of the bottom
diameter = {}   # two of the coarsest spacings

)",
                       centre.x(), centre.y(), number_text(diameter)) +
           quantity("pressure_bottom_peak", "maximum", "pressure_bottom", "Pa");
}

std::string quantities(const SceneParts& p) {
    std::string text = quantity("force_peak", "maximum", "body_force_y_filtered", "N/m") +
                       quantity("force_peak_time", "time_of_maximum", "body_force_y_filtered", "s");
    if (!p.falls()) return text;
    text += quantity("deceleration_peak", "maximum", "body_acceleration_y_filtered", "m/s^2");
    return text + fmt::format(R"([[quantities]]
name = "velocity_at_end"
metric = "value_at"
series = "body_velocity_y"
threshold = {}   # s on the clock of the run
unit = "m/s"

)",
                              number_text(p.c.end - p.c.sample));
}

std::string comparison(const SceneParts& p) {
    const char* column = p.falls() ? "vy" : "F";
    return comment(fmt::format(
               "To compare with your own curve, remove the '#' of these lines and name your file: "
               "measured.csv beside this one, with the columns t and {}.",
               column)) +
           fmt::format(R"(# [[compare]]
# title = "{} against the drop test"
# quantity = "{}"
# reference = "measured"
# x_column = "t"
# y_column = "{}"
# x_origin = "contact"
# x_scale = "millisecond"
# window = [0.0, {:.3g}]   # ms from contact
# tolerance = 0.15         # rms difference over the range of the measurement
# x_label = "time from contact [ms]"
)",
                       p.falls() ? "Velocity" : "Force",
                       p.falls() ? "body_velocity_y" : "body_force_y_filtered", column, 995 * p.c.record);
}

}  // namespace

std::string analysis_text(const SceneParts& parts) {
    return gauge(parts) + quantities(parts) + comparison(parts);
}

}  // namespace wetdeck
