// SPDX-License-Identifier: BSD-3-Clause
// How values scatter among runs that differ by the arrangement of the particles alone.
#include <fmt/format.h>

#include "reports/figures/words.hpp"
#include "reports/parts/tables.hpp"

namespace wetdeck::report {

std::string replicates_table(const Summary& summary, const AnalysisSpec& scene) {
    Table table({"variant", "quantity", "runs", "mean", "standard deviation", "95 % interval of the mean",
                 "reference", "its standard uncertainty", "area metric"},
                "compact");
    double dx = 0;
    for (const ReplicateRow& row : summary.replicates) {
        if (row.scene != scene.scene) continue;
        dx = row.dx;
        table.add(
            {markup(escape(row.variant), "name"), named(quantity_words(scene, row.quantity), row.quantity),
             whole(static_cast<double>(row.value.size())), value(row.mean, row.unit),
             value(row.deviation, row.unit), text(number(row.low, 4) + " to " + number(row.high, 4)),
             value(row.reference, row.unit), value(row.u_reference, row.unit), value(row.area, row.unit)});
    }
    if (table.empty()) return "";
    return details("Values of all replicates", table.html()) +
           paragraph(fmt::format(
                         "Runs at {} m whose particles start elsewhere, by at most a tenth of a spacing, and "
                         "at rest: what differs among them is chance. The standard deviation enters u_num. "
                         "Area metric: the area between the distribution functions of the replicates and of "
                         "the reference, zero only where both are the same.",
                         number(dx, 4)),
                     "soft");
}

}  // namespace wetdeck::report
