// SPDX-License-Identifier: BSD-3-Clause
// Cost: every run, speed against error, revisions.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/figures/figures.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/cost.hpp"

namespace wetdeck::report {
namespace {

std::vector<Cell> cost_cells(const RunRecord& record) {
    const RunCost& cost = record.cost;
    return {value(record.particle_spacing, "-", 4),
            status_cell(record),
            whole(static_cast<double>(record.fluid_particles)),
            whole(static_cast<double>(cost.steps)),
            value(cost.wall_s),
            value(cost.core_s),
            value(particle_rate(cost)),
            value(cost.peak_rss_mb)};
}

std::string runs_table(const Summary& summary) {
    Table table({"scene", "variant", "dx [m]", "status", "fluid particles", "steps", "wall time [s]",
                 "core-seconds", "particle-steps/s", "memory [MB]"},
                "compact");
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        const Runs runs = runs_of(summary, scene);
        for (const std::string& variant : variants_of(runs)) {
            const Runs rows = with_variant(runs, variant);
            for (const RunSummary* run : rows) {
                std::vector<Cell> cells = cost_cells(run->record);
                if (run == rows.front())
                    cells.insert(cells.begin(), {markup(escape(variant), "name", rows.size())});
                if (run == runs.front())
                    cells.insert(cells.begin(), {named(scene.title.empty() ? scene.scene : scene.title,
                                                       scene.scene, "name", runs.size())});
                table.add(cells);
            }
        }
    }
    return table.empty() ? paragraph("There are no runs.", "notice") : table.html();
}

/// The program revisions that made the runs, oldest first.
std::string revisions_table(const Summary& summary) {
    struct Entry {
        std::string first, last;
        std::size_t runs = 0;
    };
    std::map<std::string, Entry> revisions;
    for (const RunSummary& run : summary.runs) {
        const std::string start = provenance_of(run.record, "start_time");
        Entry& entry = revisions[revision_of(run)];
        entry.first = entry.runs == 0 ? start : std::min(entry.first, start);
        entry.last = std::max(entry.last, start);
        ++entry.runs;
    }
    std::vector<std::pair<std::string, Entry>> sorted(revisions.begin(), revisions.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
    Table table({"program revision", "runs", "first run started", "last run started"});
    for (const auto& [revision, entry] : sorted) {
        table.add({text(revision), whole(static_cast<double>(entry.runs)),
                   markup(escape(entry.first), "name"), markup(escape(entry.last), "name")});
    }
    return table.html();
}

}  // namespace

void add_cost_part(Page& page, const Summary& summary) {
    page.section(2, "Speed against error");
    page.add(
        paragraph("Each point is a run, labelled with its particle spacing; lines connect the spacings of a "
                  "variant. Rings mark the Pareto-optimal runs: no other run is better in cost or error "
                  "without being worse in the other. Variants should be compared at equal error, not at "
                  "equal spacing."));
    std::vector<Figure> figures;
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        Figure figure = speed_error_figure(summary, scene);
        if (!figure.series.empty()) figures.push_back(std::move(figure));
    }
    page.add_figures(figures);
    if (figures.empty()) page.add(paragraph("No run has both a cost and an error.", "soft"));
    page.add(cheapest_table(summary));
    page.add(peer_points_table(summary));

    page.section(2, "Runs");
    page.add(runs_table(summary));

    page.section(2, "Revisions");
    page.add(revisions_table(summary));
}

}  // namespace wetdeck::report
