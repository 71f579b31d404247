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
    Table table({"class", "against", "values", "bias (factor)", "its 95 % interval", "scatter"}, "compact");
    for (const ClassStatistics& row : summary.statistics) {
        const bool interval = row.bias_low && row.bias_high;
        table.add({text(row.quantity_class), text(describe(row.against).heading),
                   whole(static_cast<double>(row.count)), value(row.bias),
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
    const std::vector<LibraryCase> library = library_of(summary);
    for (const LibraryCase& each : library) {
        const AnalysisSpec& scene = each.scene;
        const auto sketch = inputs.sketches.find(scene.scene);
        const auto address = scene_pages.find(scene.scene);
        const std::string title = escape(scene.title.empty() ? scene.scene : scene.title);
        table.add(
            {sketch == inputs.sketches.end()
                 ? text("—")
                 : markup(fmt::format("<img class=\"set-up\" alt=\"set-up\" src=\"{}\">",
                                      svg_address(sketch->second))),
             markup(address == scene_pages.end()
                        ? title
                        : fmt::format("<a href=\"{}\">{}</a>", address->second, title)),
             text(scene.purpose),
             text(each.judged.kinds.empty() ? "—" : fmt::format("{}", fmt::join(each.judged.kinds, ", "))),
             text(fmt::format("{} of {} within", each.judged.within, each.judged.points)),
             markup(badge(each.outcome.verdict, each.outcome.tone)), value(each.core_seconds)});
    }
    page.add(paragraph(counted(library)));
    page.add(table.html());
    if (const std::string bias = bias_table(summary); !bias.empty()) {
        page.section(2, "Bias and scatter over all cases");
        page.add(bias);
        page.add(paragraph(
            "Bias is the mean factor of computed over measured or exact values; the page of statistics "
            "has every point.",
            "soft"));
    }
}

}  // namespace wetdeck::report
