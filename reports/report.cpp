// SPDX-License-Identifier: BSD-3-Clause
// Puts the parts of the report together, page by page.
#include "reports/report.hpp"

#include <algorithm>

#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"
#include "reports/parts/parts.hpp"

namespace wetdeck::report {
namespace {

std::string title_of(const Summary& summary, const ReportInputs& inputs) {
    const std::string tier = summary.tier.empty() ? "tier unknown" : "tier " + summary.tier;
    const std::string title = "wetdeck report, " + (inputs.subject.empty() ? tier : inputs.subject);
    return summary.missing.empty() ? title : "INCOMPLETE: " + title;
}

void add_statistics_page(Pages& pages, const Summary& summary) {
    Page& page = pages.add("statistics", "Statistics over all scenes", "statistics");
    add_verdicts_part(page, summary);
    add_statistics_part(page, summary);
    add_convergence_part(page, summary);
    add_cost_part(page, summary);
}

}  // namespace

void write_report(const std::filesystem::path& directory, const Summary& summary,
                  const ReportInputs& inputs) {
    Pages pages(directory, inputs.plotly, stamp_of(summary), inputs.single_file);
    Page& overview = pages.add("index", title_of(summary, inputs), "overview");
    std::map<std::string, std::string> scene_pages;
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        Page& page = pages.add("scene-" + slug(scene.scene), scene.title.empty() ? scene.scene : scene.title,
                               scene_label(scene.scene));
        scene_pages[scene.scene] = pages.address_of_page(page.name());
        add_scene_part(page, summary, scene, inputs);
    }
    if (scene_pages.size() > 1)
        add_library_part(pages.add("library", "Library of cases", "library"), summary, inputs, scene_pages);
    if (about_runs(summary)) add_statistics_page(pages, summary);
    if (!summary.verification.empty())
        add_verification_part(
            pages.add("exact-solutions", "Problems with exact solutions", "exact solutions"), summary);
    if (!summary.stress.empty())
        add_stress_part(pages.add("hard-cases", "Hard cases", "hard cases"), summary, inputs);
    if (about_runs(summary)) add_source_figures_part(pages, summary);
    add_overview(overview, summary, inputs, scene_pages);
    add_codes_part(overview, summary, inputs.codes);
    pages.write();
}

}  // namespace wetdeck::report
