// SPDX-License-Identifier: BSD-3-Clause
// What comes first: runs that died or are missing, values and curves outside tolerance.
#include <algorithm>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

/// Runs that died and runs that are not there.
std::string dead_runs(const Summary& summary) {
    Table table({"run", "status", "reason"});
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        for (const RunSummary* run : runs_of(summary, scene)) {
            if (run->record.status == RunStatus::ok) continue;
            table.add(
                {text(run_name(*run)), status_cell(run->record),
                 text(run->record.stop_reason.empty() ? "no reason recorded" : run->record.stop_reason)});
        }
    }
    for (const std::string& missing : summary.missing) {
        table.add({text(missing), markup("<span class=\"badge bad\">missing</span>"),
                   text("asked for by the tier, not in the directory")});
    }
    return table.empty() ? "" : table.html();
}

void add_quantity_failure(Table& table, const RunSummary& run, const QuantityResult& q) {
    const bool not_reached = q.expected && !q.value;
    if (q.within.value_or(true) && !not_reached) return;
    const std::string source = q.expected_source.empty() ? "" : ", " + q.expected_source;
    table.add({text(run_name(run)), text(q.name),
               text("expected " + number_with_unit(q.expected, q.unit) + source),
               not_reached ? text("not computed: " + q.note) : value(q.value, q.unit),
               text("± " + number_with_unit(q.tolerance, q.unit))});
}

void add_comparison_failure(Table& table, const RunSummary& run, const ComparisonResult& c) {
    if (verdict_of(c).value_or(true)) return;
    table.add({text(run_name(run)), text(c.title), text(c.reference + ": " + kind_name(c.kind)),
               text(c.nrmse ? "nrmse " + number(*c.nrmse) : "not computed: " + c.note),
               text(number(c.tolerance))});
}

/// Values and curves of these runs that lie outside their tolerance or could not be computed.
std::string outside_table(const Runs& runs) {
    Table table({"run", "what", "against", "value", "tolerance"});
    for (const RunSummary* run : runs) {
        for (const QuantityResult& q : run->quantities) add_quantity_failure(table, *run, q);
        for (const ComparisonResult& c : run->comparisons) add_comparison_failure(table, *run, c);
    }
    return table.empty() ? "" : table.html();
}

/// Runs of `all` that are not in `some`.
Runs others(const Runs& all, const Runs& some) {
    Runs out;
    std::copy_if(all.begin(), all.end(), std::back_inserter(out), [&](const RunSummary* run) {
        return std::find(some.begin(), some.end(), run) == some.end();
    });
    return out;
}

}  // namespace

std::optional<bool> verdict_of(const ComparisonResult& comparison) {
    return comparison.available ? std::optional(comparison.within) : std::nullopt;
}

void add_failures(Page& page, const Summary& summary) {
    page.section(2, "Failures");
    const std::string dead = dead_runs(summary);
    std::string finest;
    std::string coarser;
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        const Runs runs = runs_of(summary, scene);
        finest += outside_table(finest_of_each(runs));
        coarser += outside_table(others(runs, finest_of_each(runs)));
    }
    if (!dead.empty()) page.add("<h4>Runs that did not reach their end, and missing runs</h4>\n" + dead);
    if (!finest.empty()) page.add("<h4>Outside tolerance at the finest spacing of a variant</h4>\n" + finest);
    if (!coarser.empty()) page.add(details("Outside tolerance at coarser spacings", coarser));
    if (dead.empty() && finest.empty() && coarser.empty()) {
        page.add(paragraph("Every run reached its end and everything with a tolerance lies within it."));
    }
}

}  // namespace wetdeck::report
