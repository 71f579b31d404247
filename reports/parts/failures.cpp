// SPDX-License-Identifier: BSD-3-Clause
// Runs that became unstable, failed or are missing; values and curves outside tolerance.
#include <fmt/format.h>

#include <algorithm>

#include "reports/figures/words.hpp"
#include "reports/parts/outcomes.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/flow_flags.hpp"

namespace wetdeck::report {
namespace {

/// Variant in one line, spacing in a second.
std::string run_label(const RunSummary& run) {
    return fmt::format("{}<br>{}", escape(run.record.variant),
                       escape(spacing_text(run.record.particle_spacing)));
}

bool completed(const RunSummary& run) {
    return run.record.status == RunStatus::ok;
}

std::string reason_of(const RunSummary& run) {
    return run.record.stop_reason.empty() ? "no reason recorded" : run.record.stop_reason;
}

Table stopped_runs(const Runs& runs, bool as_expected) {
    Table table({"run", "status", "reason"});
    for (const RunSummary* run : runs) {
        if (completed(*run) || unstable_as_expected(*run) != as_expected) continue;
        table.add(
            {markup(run_label(*run), "name"),
             as_expected ? markup(badge("unstable, as expected", Tone::open)) : status_cell(run->record),
             text(reason_of(*run))});
    }
    return table;
}

using Row = std::vector<Cell>;

std::optional<Row> quantity_failure(const AnalysisSpec& scene, const QuantityResult& q,
                                    const RunRecord& record) {
    const bool not_reached = q.expected && !q.value && !stopped_early(record);
    if (q.within.value_or(true) && !not_reached) return std::nullopt;
    const std::string source = q.expected_source.empty() ? "" : ", " + q.expected_source;
    return Row{named(quantity_words(scene, q.name), q.name),
               text("expected " + number_with_unit(q.expected, q.unit) + source),
               not_reached ? text("not computed: " + q.note) : value(q.value, q.unit),
               markup(escape("± " + number_with_unit(q.tolerance, q.unit)), "number")};
}

std::optional<Row> comparison_failure(const ComparisonResult& c) {
    if (verdict_of(c).value_or(true)) return std::nullopt;
    return Row{named(c.title, c.quantity), text(fmt::format("{}, {}", c.reference, name_of(c.kind))),
               c.nrmse ? markup(fmt::format("NRMSE {}", number(*c.nrmse)), "number")
                       : text(fmt::format("not computed: {}", c.note)),
               value(c.tolerance)};
}

std::vector<Row> failures_of(const AnalysisSpec& scene, const RunSummary& run) {
    std::vector<Row> rows;
    for (const QuantityResult& q : run.quantities) {
        if (auto row = quantity_failure(scene, q, run.record)) rows.push_back(std::move(*row));
    }
    for (const ComparisonResult& c : run.comparisons) {
        if (auto row = comparison_failure(c)) rows.push_back(std::move(*row));
    }
    return rows;
}

/// Values and curves of these runs that lie outside their tolerance or could not be computed; not of runs
/// that did not complete, which have a table of their own.
std::string outside_table(const AnalysisSpec& scene, const Runs& runs) {
    Table table({"run", "quantity or curve", "compared with", "value", "tolerance"});
    for (const RunSummary* run : runs) {
        if (!completed(*run)) continue;
        std::vector<Row> rows = failures_of(scene, *run);
        for (Row& row : rows) {
            if (&row == &rows.front()) row.insert(row.begin(), markup(run_label(*run), "name", rows.size()));
            table.add(row);
        }
    }
    return table.empty() ? "" : table.html();
}

/// Runs that reached their end with a density error or particles outside the tank that make them doubtful.
Table doubtful_flows(const Runs& runs) {
    Table table({"run", "doubt"});
    for (const RunSummary* run : runs) {
        if (!completed(*run)) continue;
        for (const std::string& flag : flow_flags(run->record))
            table.add({markup(run_label(*run), "name"), text(flag)});
    }
    return table;
}

/// Runs of `all` that are not in `some`.
Runs others(const Runs& all, const Runs& some) {
    Runs out;
    std::copy_if(all.begin(), all.end(), std::back_inserter(out), [&](const RunSummary* run) {
        return std::find(some.begin(), some.end(), run) == some.end();
    });
    return out;
}

/// What the tables of values and curves leave out.
std::string notes_on(const Runs& runs) {
    std::string notes;
    const auto stopped =
        std::count_if(runs.begin(), runs.end(), [](const RunSummary* run) { return !completed(*run); });
    if (stopped > 0) {
        notes += paragraph(
            fmt::format("Values and curves of the runs that became unstable or failed ({}) are not listed "
                        "again as outside tolerance.",
                        stopped),
            "soft");
    }
    const auto early = std::count_if(runs.begin(), runs.end(),
                                     [](const RunSummary* run) { return stopped_early(run->record); });
    if (early > 0) {
        notes += paragraph(
            fmt::format("{} of the runs {} stopped on request before the end time of the scene; values "
                        "that need a later time are not judged.",
                        early, early == 1 ? "was" : "were"),
            "soft");
    }
    return notes;
}

}  // namespace

std::size_t outside_count(const AnalysisSpec& scene, const RunSummary& run) {
    return completed(run) ? failures_of(scene, run).size() : 0;
}

std::string incomplete_table(const Summary& summary) {
    Table table({"scene", "run", "status", "reason"});
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        for (const RunSummary* run : runs_of(summary, scene)) {
            if (completed(*run) || unstable_as_expected(*run)) continue;
            table.add({named(scene_words(summary, scene.scene), scene.scene), markup(run_label(*run), "name"),
                       status_cell(run->record), text(reason_of(*run))});
        }
    }
    for (const std::string& missing : summary.missing) {
        table.add({text("—"), text(missing), markup("<span class=\"badge bad\">missing</span>"),
                   text("part of the tier, not found in the directory")});
    }
    return table.empty() ? "" : table.html();
}

void add_failures(Page& page, const AnalysisSpec& scene, const Runs& runs) {
    page.section(2, "Failures", scene.scene);
    const Table incomplete = stopped_runs(runs, false), expected = stopped_runs(runs, true);
    const std::string finest = outside_table(scene, finest_of_each(runs));
    const std::string coarser = outside_table(scene, others(runs, finest_of_each(runs)));
    if (!incomplete.empty()) page.add("<h4>Runs that became unstable or failed</h4>\n" + incomplete.html());
    if (!finest.empty()) page.add("<h4>Outside tolerance at the finest spacing of a variant</h4>\n" + finest);
    if (!coarser.empty()) page.add(details("Outside tolerance at coarser spacings", coarser));
    const Table flagged = doubtful_flows(runs);
    if (!flagged.empty()) page.add("<h4>Runs with a doubtful flow</h4>\n" + flagged.html());
    if (!expected.empty())
        page.add(details("Runs that became unstable as their scene expects", expected.html()));
    if (incomplete.empty() && finest.empty() && coarser.empty()) {
        page.add(paragraph(
            fmt::format("Every {}run completed, and every value and curve with a tolerance lies within it{}.",
                        expected.empty() ? "" : "other ",
                        flagged.empty() ? "" : "; the flow of the runs above is doubtful all the same")));
    }
    page.add(notes_on(runs));
}

}  // namespace wetdeck::report
