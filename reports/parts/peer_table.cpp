// SPDX-License-Identifier: BSD-3-Clause
// Other codes, and the finest run, against the same measured pressures.
#include <fmt/format.h>

#include "reports/figures/reference_names.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/peer_comparison.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck::report {

std::string peer_table(const Runs& runs) {
    const RunSummary* run = finest_completed(runs);
    if (run == nullptr) return "";
    const std::optional<PeerComparison> comparison = compare_with_peers(*run);
    if (!comparison) return "";
    std::vector<std::string> headers{"simulation"};
    for (const PeerComparison::Name& name : comparison->measured)
        headers.push_back(reference_name(name.title, name.reference));
    Table table(headers, "compact");
    const auto add = [&](const std::string& name, const PeerComparison::Row& row) {
        std::vector<Cell> cells{markup(escape(name), "wide")};
        for (const std::optional<double>& rms : row.rms) cells.push_back(value(rms));
        table.add(cells);
    };
    for (const PeerComparison::Row& row : comparison->peers) add(row.name.title, row);
    for (const PeerComparison::Row& row : comparison->own) add("this program, " + row.series, row);
    return "<h4>Other codes against the same measurements</h4>\n" + table.html() +
           paragraph(
               fmt::format("Root mean square difference of the scaled pressures at {} equidistant instants "
                           "between {} and {} on the scaled time axis, with linear interpolation and without "
                           "a time shift. The curves are sampled at different heights: only rows of the same "
                           "height can be compared. This program: {}. The curves of the other codes were "
                           "read from published figures or data. If another code differs from the "
                           "measurement as much as this program, the difference is not specific to this "
                           "program; this proves neither the measurement nor the model right.",
                           comparison_instants, number(comparison->window.begin),
                           number(comparison->window.end), run_name(*run)),
               "soft");
}

}  // namespace wetdeck::report
