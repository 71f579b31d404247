// SPDX-License-Identifier: BSD-3-Clause
// This program beside other codes, on the scenes that `wetdeck peer` has run.
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"

namespace wetdeck::report {
namespace {

/// "12.3 ± 0.4", or that the uncertainty is unknown.
std::string with_uncertainty(double value, std::optional<double> uncertainty, const std::string& unit) {
    return number(value) + (uncertainty ? " ± " + number(*uncertainty) : " ± unknown") +
           (unit == "-" || unit.empty() ? "" : " " + unit);
}

}  // namespace

void add_codes_part(Page& page, const Summary& summary, const std::vector<ValidationRow>& rows) {
    if (rows.empty()) return;
    page.section(2, "Agreement between codes");
    page.add(paragraph(
        "The finest value of each code with its standard numerical uncertainty, from three spacings or "
        "meshes. Two codes agree within where the difference is at most the sum of both uncertainties. "
        "Agreement of codes is no validation: both may lack the same physics."));
    Table table({"scene", "quantity", "ours", "theirs", "difference", "verdict", "other code"}, "compact");
    for (const ValidationRow& row : rows) {
        const AnalysisSpec scene = scene_named(summary, row.scene);
        const std::string unit = unit_words(scene, row);
        table.add({markup(named_words(scene_label(row.scene), scene_words(summary, row.scene)) +
                          "<br><span class=\"soft\">" + escape(row.variant) + "</span>"),
                   named(quantity_words(scene, row.quantity), row.quantity),
                   text(with_uncertainty(row.simulated, row.u_num, unit)),
                   text(with_uncertainty(row.reference, row.u_data, unit)),
                   row.reference == 0 ? value(row.error, unit)
                                      : text(signed_number(100 * row.error / std::abs(row.reference)) + " %"),
                   markup("<b>" + escape(row.verdict) + "</b>"), text(row.against)});
    }
    page.add(table.html());
}

}  // namespace wetdeck::report
