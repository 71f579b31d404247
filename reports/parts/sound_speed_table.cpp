// SPDX-License-Identifier: BSD-3-Clause
// The error by the sound speed beside that by the spacing, and the value without either.
#include <fmt/format.h>

#include "reports/figures/words.hpp"
#include "reports/parts/tables.hpp"

namespace wetdeck::report {
namespace {

/// "13.1 / 14.0 / 14.3"
std::string listed(const std::vector<double>& values) {
    std::string all;
    for (const double each : values) all += (all.empty() ? "" : " / ") + number(each, 4);
    return all;
}

}  // namespace

std::string sound_speed_table(const Summary& summary, const AnalysisSpec& scene) {
    Table table({"variant", "quantity", "c [m/s]", "value at these c, one dx", "part of the sound speed",
                 "value at the finest dx", "part of the spacing", "c → ∞, dx → 0", "expected"},
                "compact");
    for (const SoundSpeedRow& row : summary.sound_speed) {
        if (row.scene != scene.scene) continue;
        const std::string spread =
            row.u_limit ? " ± " + number(*row.u_limit) : " ± at least " + number(row.u_sound);
        table.add({markup(escape(row.variant), "name"),
                   named(quantity_words(scene, row.quantity), row.quantity), text(listed(row.sound_speed)),
                   text(fmt::format("{} (dx {} m)", listed(row.value), number(row.dx, 4))),
                   text(signed_number(row.sound_part)),
                   text(fmt::format("{} (dx {} m)", number(row.finest_value), number(row.finest_dx, 4))),
                   text(row.spacing_part ? signed_number(*row.spacing_part) : "unknown"),
                   text(number_with_unit(row.limit, row.unit) + spread),
                   row.expected ? value(row.expected, row.unit) : text("—")});
    }
    if (table.empty())
        return scene.sound_speed_variants.empty()
                   ? ""
                   : paragraph(
                         "The scene asks for runs at a half and twice the sound speed, but this directory "
                         "does not hold them.",
                         "soft");
    return table.html() +
           paragraph(
               "The coarsest spacing of a variant is run at a half, once and twice its sound speed c; a "
               "line f = f∞ + a/c² through the values gives the part of the error that the finite sound "
               "speed makes, f(c) − f∞. The part of the spacing is that of Richardson's extrapolation, "
               "where the values converge monotonically; else it is unknown and not taken off. The limit "
               "is the value at the finest spacing less both parts. Its standard uncertainty holds the "
               "scatter about the line and u_num.",
               "soft");
}

}  // namespace wetdeck::report
