// SPDX-License-Identifier: BSD-3-Clause
// The first page.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "reports/figures/words.hpp"
#include "reports/page/thumbnail.hpp"
#include "reports/parts/outcomes.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/energy_budget.hpp"
#include "validation/metrics/flow_flags.hpp"

namespace wetdeck::report {
namespace {

using Addresses = std::map<std::string, std::string>;

std::string linked(const Addresses& pages, const std::string& scene, const std::string& words) {
    const auto found = pages.find(scene);
    if (found == pages.end()) return named_words(words, scene);
    return fmt::format("<a href=\"{}\" title=\"{}\">{}</a>", found->second, escape(scene), escape(words));
}

Cell scene_cell(const Outcome& outcome, const Addresses& pages) {
    std::string out = linked(pages, outcome.scene, outcome.title);
    if (outcome.run != nullptr)
        out += fmt::format("<br><span class=\"soft\">{}, {}</span>", escape(outcome.run->record.variant),
                           escape(spacing_text(outcome.run->record.particle_spacing)));
    return markup(out);
}

Cell expected_cell(const Outcome& outcome) {
    if (!outcome.expected) return text("—");
    std::string out = escape(number(*outcome.expected));
    if (outcome.tolerance) out += " ± " + escape(number(*outcome.tolerance));
    return markup(fmt::format("{}<br><span class=\"soft\" title=\"{}\">{}</span>", out,
                              escape(outcome.against), escape(outcome.kind)));
}

Cell verdict_cell(const Outcome& outcome) {
    std::string out = badge(outcome.verdict, outcome.tone);
    if (!outcome.open.empty()) out += "<br><span class=\"soft\">" + escape(outcome.open) + "</span>";
    if (outcome.run == nullptr) return markup(out);
    if (const auto note = compression_note(outcome.run->record))
        out += fmt::format("<br><span class=\"badge warn\" title=\"{}\">density changes by {} %</span>",
                           escape(*note),
                           number(100 * *largest_value(outcome.run->record, "density_error_max"), 2));
    return markup(out);
}

std::string outcomes_table(const Summary& summary, const Addresses& pages) {
    Table table({"scene", "main quantity", "expected", "reached", "unit", "verdict", "core-seconds", "curve"},
                "compact stacked outcomes");
    for (const Outcome& o : outcomes_of(summary)) {
        table.add({scene_cell(o, pages), named(o.words.empty() ? "—" : o.words, o.quantity), expected_cell(o),
                   value(o.reached), text(o.unit == "-" ? "—" : o.unit), verdict_cell(o),
                   o.run == nullptr ? text("—") : value(o.run->record.cost.core_s),
                   markup(thumbnail(outcome_figure(o)))});
    }
    return table.html() +
           paragraph(
               "The default variant of each scene at its finest spacing, and the cost of that run. Curve: "
               "simulation blue, reference black. A verdict holds with 95 % confidence: \"refine first\" and "
               "\"within the uncertainty\" show no error.",
               "soft");
}

/// Everything that is no default variant at its finest spacing, counted; the pages of the scenes list it.
std::string rest_table(const Summary& summary, const Addresses& pages) {
    Table table({"scene", "variants", "runs", "unstable as expected", "outside tolerance, finest spacings",
                 "outside tolerance, coarser", "core-seconds of all runs"},
                "compact");
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        const Runs runs = runs_of(summary, scene);
        if (runs.empty()) continue;
        const Runs finest = finest_of_each(runs);
        std::size_t expected = 0, fine = 0, coarse = 0;
        double cost = 0;
        for (const RunSummary* run : runs) {
            const bool is_finest = std::find(finest.begin(), finest.end(), run) != finest.end();
            (is_finest ? fine : coarse) += outside_count(scene, *run);
            expected += unstable_as_expected(*run) ? 1 : 0;
            cost += run->record.cost.core_s;
        }
        std::string variants;
        for (const std::string& variant : variants_of(runs))
            variants += (variants.empty() ? "" : ", ") + variant;
        const auto whole_of = [](std::size_t n) { return whole(static_cast<double>(n)); };
        table.add({markup(linked(pages, scene.scene, scene_words(summary, scene.scene))), text(variants),
                   whole_of(runs.size()), whole_of(expected), whole_of(fine), whole_of(coarse), value(cost)});
    }
    return table.html();
}

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

std::string card(std::string_view figure, std::string_view words) {
    return fmt::format("<div class=\"card\"><b>{}</b><span>{}</span></div>\n", escape(figure), escape(words));
}

std::string tally_card(const Tally& tally, std::string_view words) {
    return card(fmt::format("{} of {}", tally.within, tally.judged), words);
}

std::string properties(const std::vector<std::pair<std::string, std::string>>& entries) {
    std::string out;
    for (const auto& [name, content] : entries) out += (out.empty() ? "" : " · ") + name + " " + content;
    return out.empty() ? "" : paragraph(out, "soft");
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
        out += card(std::to_string(summary.missing.size()), "runs missing");
        out += tally_card(quantities, "expected values within tolerance, all spacings");
        out += tally_card(references, "reference curves within tolerance, all spacings");
    }
    if (criteria.judged > 0) out += tally_card(criteria, "criteria met in problems with exact solutions");
    if (peers.judged > 0) out += tally_card(peers, "peer simulations within tolerance, all spacings");
    return out + "</div>\n";
}

/// What a reader misses where gnuplot or plotly.js was not at hand.
std::string drawing_notice(const Pages& page) {
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
    std::string left_out;
    for (const LeftOutRun& run : summary.left_out)
        left_out +=
            "<li>" +
            escape(fmt::format("{} is left out: {}", run.directory, fmt::join(run.differences, "; "))) +
            "</li>\n";
    if (left_out.empty()) return out;
    constexpr std::size_t most = 6;  // more would push the results off the first screen
    const std::string list = "<ul>\n" + left_out + "</ul>\n";
    return out + "<div class=\"notice\">" +
           paragraph(
               "A report holds one set-up of each variant. Runs of another set-up than the latest of their "
               "scene are not shown; make a report of them in a folder of their own.") +
           (summary.left_out.size() > most
                ? details(fmt::format("{} runs are left out", summary.left_out.size()), list)
                : list) +
           "</div>\n";
}

/// What a reader must know before the first number.
std::string notices(const Summary& summary, std::size_t stopped) {
    std::string out;
    if (!summary.missing.empty())
        out += paragraph(
            "This report is incomplete: runs of the tier are missing. They are listed under Failures.",
            "notice");
    if (stopped > 0)
        out += paragraph(fmt::format("{} became unstable or failed, and nobody expects it: see Failures.",
                                     stopped == 1 ? "1 run" : fmt::format("{} runs", stopped)),
                         "notice");
    return out + mixture_notice(summary);
}

std::string list_of_pages(const Pages& pages) {
    std::string out;
    for (const auto& [address, title] : pages.listed())
        out += fmt::format("<li><a href=\"{}\">{}</a></li>\n", address, escape(title));
    return out.empty() ? "" : "<ul>\n" + out + "</ul>\n";
}

}  // namespace

void add_overview(Page& page, const Summary& summary, const ReportInputs& inputs,
                  const std::map<std::string, std::string>& scene_pages) {
    const auto stopped = std::count_if(summary.runs.begin(), summary.runs.end(), [](const RunSummary& run) {
        return run.record.status != RunStatus::ok && !unstable_as_expected(run);
    });
    page.add(notices(summary, static_cast<std::size_t>(stopped)));
    if (about_runs(summary)) {
        page.section(2, "What was reached");
        page.add(summary.runs.empty() ? paragraph("There are no runs.", "notice")
                                      : outcomes_table(summary, scene_pages));
    }
    if (const std::string steps = next_steps(summary, scene_pages); !steps.empty()) {
        page.section(2, "What to look at next");
        page.add(steps);
    }
    if (const std::string incomplete = incomplete_table(summary); !incomplete.empty()) {
        page.section(2, "Failures");
        page.add(incomplete);
    }
    if (!summary.runs.empty()) {
        page.section(2, "Other variants, coarser spacings, other codes");
        page.add(
            paragraph("Counted here and listed on the page of each scene. An instability that a variant is "
                      "there to show is a result, no failure."));
        page.add(rest_table(summary, scene_pages));
    }
    page.section(2, "Counts");
    page.add(cards(summary));
    page.section(2, "About this report");
    page.add(paragraph(
        "Two-phase Riemann-SPH simulations of water entry and water impact, compared with measurements, "
        "exact solutions and other simulations."));
    page.add(list_of_pages(page.pages()));
    page.add(drawing_notice(page.pages()) + properties(inputs.program) + properties(inputs.machine) +
             (inputs.note.empty() ? "" : paragraph(inputs.note, "soft")));
}

}  // namespace wetdeck::report
