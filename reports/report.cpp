// SPDX-License-Identifier: BSD-3-Clause
// Puts the parts of the report together.
#include "reports/report.hpp"

#include "reports/parts.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck::report {

void write_report(const std::filesystem::path& directory, const Summary& summary,
                  const ReportInputs& inputs) {
    Page page(directory, inputs.plotly, stamp_of(summary));
    if (about_runs(summary)) {
        add_failures(page, summary);
        add_front_part(page, summary);
    }
    add_verification_part(page, summary);
    add_stress_part(page, summary, inputs);
    for (const AnalysisSpec& scene : scenes_of(summary)) add_scene_part(page, summary, scene, inputs);
    if (about_runs(summary)) add_paper_part(page, summary);

    const bool of_tier = summary.tier == "quick" || summary.tier == "standard" || summary.tier == "paper";
    std::string title = "wetdeck report, " + std::string(of_tier ? "tier " : "") +
                        (summary.tier.empty() ? "tier unknown" : summary.tier);
    if (!summary.missing.empty()) title = "INCOMPLETE: " + title;
    atomic_write(directory / "index.html", page.html(title, header_markup(summary, inputs, page)));
    page.remove_stale_figures();
}

}  // namespace wetdeck::report
