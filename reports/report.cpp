// SPDX-License-Identifier: BSD-3-Clause
// Puts the parts of the report together.
#include "reports/report.hpp"

#include "reports/page/html.hpp"
#include "reports/parts/parts.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck::report {
namespace {

std::string title_of(const Summary& summary, const ReportInputs& inputs) {
    const std::string tier = summary.tier.empty() ? "tier unknown" : "tier " + summary.tier;
    const std::string title = "wetdeck report, " + (inputs.subject.empty() ? tier : inputs.subject);
    return summary.missing.empty() ? title : "INCOMPLETE: " + title;
}

}  // namespace

void write_report(const std::filesystem::path& directory, const Summary& summary,
                  const ReportInputs& inputs) {
    Page page(directory, inputs.plotly, stamp_of(summary));
    if (about_runs(summary)) {
        add_verdicts_part(page, summary);
        add_failures(page, summary);
        add_front_part(page, summary);
    }
    add_verification_part(page, summary);
    add_stress_part(page, summary, inputs);
    for (const AnalysisSpec& scene : scenes_of(summary)) add_scene_part(page, summary, scene, inputs);
    if (about_runs(summary)) add_source_figures_part(page, summary);
    atomic_write(directory / "index.html",
                 page.html(title_of(summary, inputs), header_markup(summary, inputs, page)));
    page.remove_stale_figures();
}

}  // namespace wetdeck::report
