// SPDX-License-Identifier: BSD-3-Clause
// The library of cases: what each tests, against what, how it ended and what it cost.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/figures/words.hpp"
#include "reports/parts/outcomes.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"

namespace wetdeck::report {
namespace {

std::string bias_table(const Summary& summary) {
    Table table({"class", "values", "bias (factor)", "its 95 % interval", "scatter"}, "compact");
    for (const ClassStatistics& row : summary.statistics) {
        const bool interval = row.bias_low && row.bias_high;
        table.add({text(row.quantity_class), whole(static_cast<double>(row.count)), value(row.bias),
                   text(interval ? number(*row.bias_low) + " to " + number(*row.bias_high) : "—"),
                   value(row.scatter)});
    }
    return table.empty() ? "" : table.html();
}

}  // namespace

void add_library_part(Page& page, const Summary& summary, const ReportInputs& inputs,
                      const std::map<std::string, std::string>& scene_pages) {
    page.section(2, "Cases");
    Table table({"set-up", "case", "what it tests", "against", "judged, finest spacings", "main verdict",
                 "core-seconds of all runs"},
                "stacked outcomes");
    std::size_t points = 0, within = 0, cases = 0;
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        const Runs runs = runs_of(summary, scene);
        if (runs.empty()) continue;
        const Judged judged = judged_in(scene, runs);
        const Outcome outcome = outcome_of(summary, scene);
        double cost = 0;
        for (const RunSummary* run : runs) cost += run->record.cost.core_s;
        const auto sketch = inputs.sketches.find(scene.scene);
        const auto address = scene_pages.find(scene.scene);
        const std::string title = escape(scene.title.empty() ? scene.scene : scene.title);
        table.add({sketch == inputs.sketches.end()
                       ? text("—")
                       : markup(fmt::format("<img class=\"set-up\" alt=\"set-up\" src=\"{}\">",
                                            svg_address(sketch->second))),
                   markup(address == scene_pages.end()
                              ? title
                              : fmt::format("<a href=\"{}\">{}</a>", address->second, title)),
                   text(scene.purpose),
                   text(judged.kinds.empty() ? "—" : fmt::format("{}", fmt::join(judged.kinds, ", "))),
                   text(fmt::format("{} of {} within", judged.within, judged.points)),
                   markup(badge(outcome.verdict, outcome.tone)), value(cost)});
        points += judged.points;
        within += judged.within;
        ++cases;
    }
    page.add(
        paragraph(fmt::format("{} cases with {} judged values and curves at their finest spacings, {} "
                              "of them within tolerance.",
                              cases, points, within)));
    page.add(table.html());
    if (const std::string bias = bias_table(summary); !bias.empty()) {
        page.section(2, "Bias and scatter over all cases");
        page.add(bias);
        page.add(
            paragraph("Bias is the mean factor of computed over measured values; the page of statistics "
                      "has every point.",
                      "soft"));
    }
}

}  // namespace wetdeck::report
