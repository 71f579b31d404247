// SPDX-License-Identifier: BSD-3-Clause
#include "reports/parts/outcomes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "reports/figures/reference_names.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/resample.hpp"
#include "validation/metrics/verdict.hpp"

namespace wetdeck::report {
namespace {

using Rows = std::vector<const ValidationRow*>;

/// The rows with a verdict of the run's variant, measurements first.
Rows rows_of(const Summary& summary, const RunRecord& record) {
    Rows rows;
    for (const auto* table : {&summary.validation, &summary.agreement})
        for (const ValidationRow& row : *table)
            if (row.scene == record.scene && row.variant == record.variant) rows.push_back(&row);
    return rows;
}

const QuantitySpec* find_spec(const AnalysisSpec& scene, const std::string& name) {
    const auto found = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                    [&](const QuantitySpec& spec) { return spec.name == name; });
    return found == scene.quantities.end() ? nullptr : &*found;
}

std::string series_of(const AnalysisSpec& scene, const ValidationRow& row) {
    if (const QuantitySpec* spec = find_spec(scene, row.quantity)) return spec->series;
    for (const ComparisonSpec& spec : scene.comparisons)
        if (spec.title == row.against) return spec.quantity;
    return row.quantity.substr(0, row.quantity.find(": "));
}

/// Lower is better to show: by kind of reference, then decided before open, then by how much a value says.
auto rank(const ValidationRow& row) {
    const int kind = !row.kind || describe(*row.kind).validates ? 0
                     : describe(*row.kind).exact                ? 1
                     : *row.kind == ReferenceKind::stated       ? 3
                                                                : 2;
    return std::tuple(row.reference == 0, kind, row.verdict == "unknown");
}

const ValidationRow* main_row(const AnalysisSpec& scene, const Rows& rows, const std::string& series) {
    const ValidationRow* best = nullptr;
    for (const ValidationRow* row : rows) {
        if (row->quantity == scene.error_quantity) return row;
        if (!series.empty() && series_of(scene, *row) != series) continue;
        if (best == nullptr || rank(*row) < rank(*best)) best = row;
    }
    return best;
}

const ComparisonResult* curve_of(const RunSummary& run, const std::string& series, const std::string& title) {
    const ComparisonResult* best = nullptr;
    for (const ComparisonResult& c : run.comparisons) {
        if (c.quantity != series || !c.available || c.simulated.x.size() < 2) continue;
        if (c.title == title) return &c;
        const bool measured = c.kind == ReferenceKind::experiment;
        if (best == nullptr || (measured && best->kind != ReferenceKind::experiment)) best = &c;
    }
    return best;
}

void take(Outcome& out, const AnalysisSpec& scene, const ValidationRow& row) {
    out.quantity = row.quantity;
    out.words = quantity_words(scene, row.quantity);
    out.unit = unit_words(scene, row);
    out.expected = row.reference;
    out.reached = row.simulated;
    out.kind = kind_words(row.kind);
    out.verdict = verdict_words(scene, row);
    out.tone = tone_of(row);
    if (out.tone == Tone::open && what_would_help(row) != "—") out.open = "needs " + what_would_help(row);
    out.series = series_of(scene, row);
    out.against = row.against;
    out.curve = curve_of(*out.run, out.series, row.against);
    if (out.curve != nullptr && out.curve->title == row.against)
        out.against = reference_name(out.curve->title, out.curve->reference);
}

void take(Outcome& out, const AnalysisSpec& scene, const QuantityResult& q) {
    const QuantitySpec* spec = find_spec(scene, q.name);
    out.quantity = q.name;
    out.words = quantity_words(scene, q.name);
    out.unit = q.unit;
    out.expected = q.expected;
    out.tolerance = q.tolerance;
    out.reached = q.value;
    out.against = q.expected_source;
    if (q.expected) out.kind = kind_words(spec == nullptr ? std::nullopt : spec->expected_kind);
    out.verdict = !q.expected ? "no value to compare with"
                  : !q.value  ? "not reached"
                  : !q.within ? "not judged"
                  : *q.within ? "within tolerance"
                              : "outside tolerance";
    out.tone = q.within ? (*q.within ? Tone::good : Tone::bad) : Tone::open;
    out.series = spec == nullptr ? "" : spec->series;
    out.curve = curve_of(*out.run, out.series, "");
}

void take(Outcome& out, const AnalysisSpec& scene, const ComparisonResult& c) {
    out.quantity = c.quantity;
    out.series = c.quantity;
    out.words =
        "rms difference of the " + series_words(scene, c.quantity) + ", over the range of the reference";
    out.expected = 0;
    out.tolerance = c.tolerance;
    out.reached = c.nrmse;
    out.kind = kind_words(c.kind);
    out.against = reference_name(c.title, c.reference);
    out.verdict = c.within ? "within tolerance" : "outside tolerance";
    out.tone = c.within ? Tone::good : Tone::bad;
    out.curve = &c;
}

const QuantityResult* find_result(const RunSummary& run, const std::string& name) {
    const auto found = std::find_if(run.quantities.begin(), run.quantities.end(),
                                    [&](const QuantityResult& q) { return q.name == name; });
    return found == run.quantities.end() ? nullptr : &*found;
}

void evaluate(Outcome& out, const Summary& summary, const AnalysisSpec& scene) {
    const RunSummary& run = *out.run;
    const Rows rows = rows_of(summary, run.record);
    const QuantitySpec* main = find_spec(scene, scene.error_quantity);
    const ValidationRow* row = main == nullptr ? nullptr : main_row(scene, rows, main->series);
    if (row != nullptr) return take(out, scene, *row);
    const QuantityResult* result = find_result(run, scene.error_quantity);
    if (result != nullptr && result->expected) return take(out, scene, *result);
    row = main_row(scene, rows, "");
    if (row != nullptr) return take(out, scene, *row);
    for (const ComparisonResult& c : run.comparisons)
        if (verdict_of(c) && c.nrmse) return take(out, scene, c);
    if (result == nullptr && !run.quantities.empty()) result = &run.quantities.front();
    if (result != nullptr) return take(out, scene, *result);
    out.verdict = "nothing evaluated";
}

}  // namespace

std::string kind_words(std::optional<ReferenceKind> kind) {
    if (!kind) return "kind not stated";
    switch (*kind) {
        case ReferenceKind::experiment:
            return "experiment";
        case ReferenceKind::analytic:
            return "exact solution";
        case ReferenceKind::peer_simulation:
            return "other code";
        case ReferenceKind::stated:
            return "stated in a publication";
    }
    return "";
}

Tone tone_of(const ValidationRow& row) {
    if (row.verdict == "refine first" || row.verdict == "unknown") return Tone::open;
    return error_is_shown(row) && row.verdict != "validated" ? Tone::bad : Tone::good;
}

std::string badge(const std::string& words, Tone tone) {
    return fmt::format("<span class=\"badge {}\">{}</span>",
                       tone == Tone::good  ? "good"
                       : tone == Tone::bad ? "bad"
                                           : "warn",
                       escape(words));
}

Outcome outcome_of(const Summary& summary, const AnalysisSpec& scene) {
    Outcome outcome;
    outcome.scene = scene.scene;
    outcome.title = scene.title.empty() ? scene.scene : scene.title;
    const Runs runs = runs_of(summary, scene);
    if (runs.empty()) {
        outcome.verdict = "not run";
        return outcome;
    }
    outcome.run = finest_of_each(runs).front();
    const RunRecord& record = outcome.run->record;
    if (record.status == RunStatus::ok) {
        evaluate(outcome, summary, scene);
        return outcome;
    }
    const bool expected = unstable_as_expected(*outcome.run);
    outcome.verdict = record.status == RunStatus::unstable ? "became unstable" : "failed";
    if (expected) outcome.verdict += ", as expected";
    outcome.tone = expected ? Tone::open : Tone::bad;
    return outcome;
}

std::vector<Outcome> outcomes_of(const Summary& summary) {
    std::vector<Outcome> out;
    for (const AnalysisSpec& scene : scenes_of(summary)) out.push_back(outcome_of(summary, scene));
    return out;
}

Judged judged_in(const AnalysisSpec& scene, const Runs& runs) {
    Judged judged;
    const auto take = [&judged](bool inside, std::optional<ReferenceKind> kind) {
        ++judged.points;
        judged.within += inside ? 1 : 0;
        judged.kinds.insert(kind_words(kind));
    };
    for (const RunSummary* run : finest_of_each(runs)) {
        if (run->expected_unstable) continue;
        for (const QuantityResult& q : run->quantities) {
            if (!q.within) continue;
            const auto spec = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                           [&q](const QuantitySpec& each) { return each.name == q.name; });
            take(*q.within, spec == scene.quantities.end() ? std::nullopt : spec->expected_kind);
        }
        for (const ComparisonResult& c : run->comparisons)
            if (c.available && c.judged) take(c.within, c.kind);
    }
    return judged;
}

std::vector<LibraryCase> library_of(const Summary& summary) {
    std::vector<LibraryCase> library;
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        const Runs runs = runs_of(summary, scene);
        if (runs.empty()) continue;
        library.push_back({scene, runs, judged_in(scene, runs), outcome_of(summary, scene)});
        for (const RunSummary* run : runs) library.back().core_seconds += run->record.cost.core_s;
    }
    return library;
}

std::string counted(const std::vector<LibraryCase>& library) {
    std::size_t points = 0, within = 0;
    for (const LibraryCase& each : library) {
        points += each.judged.points;
        within += each.judged.within;
    }
    return fmt::format(
        "{} cases with {} judged values and curves at their finest spacings, {} of them within tolerance.",
        library.size(), points, within);
}

Figure outcome_figure(const Outcome& outcome) {
    Figure figure;
    figure.title = outcome.words + (outcome.curve == nullptr ? "" : ": simulation and reference");
    if (const ComparisonResult* c = outcome.curve; c != nullptr) {
        figure.x.range = c->window ? *c->window : extent(c->measured);
        PlotSeries reference = line("", c->measured, "#111111");
        reference.style = c->kind == ReferenceKind::experiment || c->kind == ReferenceKind::stated
                              ? Style::points
                              : Style::dashed;
        figure.series = {line("", c->simulated, "#08519c"), reference};
        for (PlotSeries& series : figure.series) {
            const auto common = overlap(series.data, *figure.x.range);
            if (common) series.data = clip(series.data, *common);
        }
    } else if (outcome.run != nullptr) {
        const auto found = outcome.run->record.series.find(outcome.series);
        if (found != outcome.run->record.series.end() && found->second.columns() == 1)
            figure.series = {line("", {found->second.time, found->second.value}, "#08519c")};
    }
    return figure;
}

}  // namespace wetdeck::report
