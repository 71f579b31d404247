// SPDX-License-Identifier: BSD-3-Clause
// The first page: introduction, runs, speed against error, revisions.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/figures/figures.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/cost.hpp"

namespace wetdeck::report {
namespace {

/// Verdicts counted.
struct Tally {
    std::size_t within = 0;
    std::size_t judged = 0;

    void take(std::optional<bool> verdict) {
        if (!verdict) return;
        ++judged;
        if (*verdict) ++within;
    }
};

std::string card(std::string_view figure, std::string_view words, std::string_view css_class = "") {
    return fmt::format("<div class=\"card {}\"><b>{}</b><span>{}</span></div>\n", css_class, escape(figure),
                       escape(words));
}

std::string tally_card(const Tally& tally, std::string_view words) {
    const bool all = tally.within == tally.judged;
    return card(fmt::format("{} of {}", tally.within, tally.judged), words,
                tally.judged == 0 ? "" : (all ? "good" : "bad"));
}

std::string properties(const std::vector<std::pair<std::string, std::string>>& entries) {
    std::string out;
    for (const auto& [name, content] : entries) out += (out.empty() ? "" : " · ") + name + " " + content;
    return out.empty() ? "" : paragraph(out, "soft");
}

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
                    cells.insert(cells.begin(), {markup(escape(scene.scene), "name", runs.size())});
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

/// Counts of what completed and what lies within its tolerance.
std::string cards(const Summary& summary) {
    Tally completed, quantities, references, peers, criteria;
    for (const RunSummary& run : summary.runs) {
        if (!unstable_as_expected(run)) completed.take(run.record.status == RunStatus::ok);
        for (const QuantityResult& q : run.quantities) quantities.take(q.within);
        for (const ComparisonResult& c : run.comparisons)
            (c.kind == ReferenceKind::peer_simulation ? peers : references).take(verdict_of(c));
    }
    for (const VerificationProblem& problem : summary.verification) {
        for (const VerificationRow& row : problem.rows) criteria.take(row.within);
    }
    std::string out = "<div class=\"cards\">\n";
    if (about_runs(summary)) {
        const auto expected = std::count_if(summary.runs.begin(), summary.runs.end(), unstable_as_expected);
        out += tally_card(completed, expected == 0 ? "runs completed"
                                                   : fmt::format("runs completed, besides {} that became "
                                                                 "unstable as expected",
                                                                 expected));
        out += card(std::to_string(summary.missing.size()), "runs missing",
                    summary.missing.empty() ? "good" : "bad");
        out += tally_card(quantities, "expected values within tolerance, all spacings");
        out += tally_card(references, "reference curves within tolerance, all spacings");
    }
    if (criteria.judged > 0) out += tally_card(criteria, "criteria met in problems with exact solutions");
    if (peers.judged > 0) out += tally_card(peers, "peer simulations within tolerance, all spacings");
    return out + "</div>\n";
}

/// What a reader misses where gnuplot or plotly.js was not at hand.
std::string drawing_notice(const Page& page) {
    if (page.draws_static() && page.draws_interactive()) return "";
    if (page.draws_static())
        return paragraph("plotly.js was not built into this program: the figures are static.", "notice");
    return paragraph(page.draws_interactive()
                         ? "gnuplot was not found when this report was written: figures need JavaScript "
                           "and do not print."
                         : "gnuplot was not found and plotly.js was not built in: figures are not drawn, "
                           "only their CSV files are written.",
                     "notice");
}

/// What a reader must know where runs of different schemes or set-ups lie in one directory.
std::string mixture_notice(const Summary& summary) {
    std::set<std::string> revisions;
    for (const RunSummary& run : summary.runs) {
        const auto found = run.record.parameters.find("scheme_revision");
        revisions.insert(found == run.record.parameters.end() ? "unknown" : number(found->second));
    }
    std::string out;
    if (revisions.size() > 1)
        out +=
            paragraph(fmt::format("The runs were made with different revisions of the numerical scheme ({}).",
                                  fmt::join(revisions, ", ")),
                      "notice");
    for (const LeftOutRun& run : summary.left_out)
        out += paragraph(fmt::format("{} is left out, because its set-up is not that of the latest run of "
                                     "the scene: {}. A report holds one set-up of each variant; make one of "
                                     "the other runs in a folder of their own.",
                                     run.directory, fmt::join(run.differences, "; ")),
                         "notice");
    return out;
}

/// Time origins that a reader should not trust, one paragraph a run.
std::string doubts_notice(const Summary& summary) {
    std::string out;
    for (const RunDoubt& doubt : summary.doubts) {
        if (doubt.about != RunDoubt::About::time_origin) continue;
        const std::string with = doubt.overrides.empty() ? "" : fmt::format(" with {}", doubt.overrides);
        out += paragraph(fmt::format("Doubt about {} {} dx {}{}: {}", doubt.scene, doubt.variant,
                                     number(doubt.dx), with, doubt.sentence),
                         "notice");
    }
    return out;
}

}  // namespace

std::string header_markup(const Summary& summary, const ReportInputs& inputs, const Page& page) {
    std::string out = paragraph(
        "Two-phase Riemann-SPH simulations of water entry and water impact, compared with measurements, "
        "exact solutions and other simulations.",
        "lead");
    out += cards(summary);
    out += mixture_notice(summary);
    out += doubts_notice(summary);
    if (!summary.missing.empty()) {
        out += paragraph(
            "This report is incomplete: runs of the tier are missing. They are listed under Failures.",
            "notice");
    }
    return out + drawing_notice(page) + properties(inputs.program) + properties(inputs.machine) +
           (inputs.note.empty() ? "" : paragraph(inputs.note, "soft"));
}

void add_front_part(Page& page, const Summary& summary) {
    page.section(2, "Runs");
    page.add(runs_table(summary));

    add_statistics_part(page, summary);

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

    page.section(2, "Revisions");
    page.add(revisions_table(summary));
}

}  // namespace wetdeck::report
