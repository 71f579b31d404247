// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

using Measure = SourceStatement::Measure;

/// Sound runs of one variant by spacing.
std::map<double, const RunSummary*> by_spacing(const std::vector<RunSummary>& runs, const std::string& scene,
                                               const std::string& variant) {
    std::map<double, const RunSummary*> found;
    for (const RunSummary& run : runs) {
        const RunRecord& record = run.record;
        if (record.scene == scene && record.variant == variant && counts(run))
            found[record.particle_spacing] = &run;
    }
    return found;
}

const QuantityResult* find_quantity(const RunSummary& run, const std::string& name) {
    const auto found = std::find_if(run.quantities.begin(), run.quantities.end(),
                                    [&](const QuantityResult& q) { return q.name == name; });
    return found != run.quantities.end() && found->value ? &*found : nullptr;
}

void relate_quantities(const SourceStatement& statement, const RunSummary& a, const RunSummary& b,
                       StatementResult& result) {
    const QuantityResult* of_a = find_quantity(a, statement.quantity);
    const QuantityResult* of_b = find_quantity(b, statement.against_quantity);
    if (!of_a || !of_b) {
        result.note = fmt::format("no value of {}", !of_a ? statement.quantity : statement.against_quantity);
    } else if (statement.measure == Measure::difference) {
        result.value = *of_a->value - *of_b->value;
        result.unit = of_a->unit;
    } else if (*of_b->value == 0) {
        result.note = fmt::format("{} is zero", statement.against_quantity);
    } else {
        result.value = *of_a->value / *of_b->value;
    }
}

void relate_curves(const SourceStatement& statement, const RunSummary& a, const RunSummary& b,
                   StatementResult& result) {
    const SeriesCurve of_a = series_curve(a.record, statement.quantity);
    const SeriesCurve of_b = series_curve(b.record, statement.quantity);
    result.note = !of_a.problem.empty() ? of_a.problem : of_b.problem;
    if (!result.note.empty()) return;
    const Window window = statement.window.value_or(extent(of_b.curve));
    if (!covers(of_a.curve, window) || !covers(of_b.curve, window)) {
        result.note = "a series does not cover the window";
        return;
    }
    const Curve part = clip(of_b.curve, window);
    const auto [low, high] = std::minmax_element(part.y.begin(), part.y.end());
    if (*high > *low)
        result.value = rms_difference(of_a.curve, of_b.curve, window) / (*high - *low);
    else
        result.note = "the second curve is constant";
}

std::string in_words(const SourceStatement& s) {
    switch (s.measure) {
        case Measure::difference:
            return s.quantity + ", difference";
        case Measure::ratio:
            return s.quantity + ", ratio";
        case Measure::curve_difference:
            return s.quantity + "(t), rms difference over range";
    }
    return {};
}

StatementResult judge(const SourceStatement& statement, std::size_t place, const std::string& scene,
                      const std::vector<RunSummary>& runs) {
    StatementResult result{scene, statement.says, statement.variants[place], {}, in_words(statement)};
    result.low = statement.low;
    result.high = statement.high;
    const bool one_run = statement.against.empty();
    const std::string other = one_run ? result.variant : statement.against[place];
    result.against = one_run ? statement.against_quantity : other;
    const auto ours = by_spacing(runs, scene, result.variant);
    const auto theirs = by_spacing(runs, scene, other);
    const auto both = std::find_if(ours.begin(), ours.end(),
                                   [&](const auto& entry) { return theirs.contains(entry.first); });
    if (both == ours.end()) {
        result.note = one_run ? "no run" : "no spacing that both variants were run at";
        return result;
    }
    result.dx = both->first;
    const RunSummary& a = *both->second;
    const RunSummary& b = *theirs.at(both->first);
    statement.measure == Measure::curve_difference ? relate_curves(statement, a, b, result)
                                                   : relate_quantities(statement, a, b, result);
    return result;
}

bool is_stated(const AnalysisSpec& scene, const std::string& quantity) {
    return std::any_of(scene.quantities.begin(), scene.quantities.end(), [&](const QuantitySpec& q) {
        return q.name == quantity && q.expected_kind == ReferenceKind::stated;
    });
}

void add_stated_values(const AnalysisSpec& scene, const std::vector<RunSummary>& runs,
                       std::vector<StatementResult>& results) {
    std::map<std::string, const RunSummary*> finest;
    for (const RunSummary& run : runs) {
        if (run.record.scene != scene.scene || !counts(run)) continue;
        const RunSummary*& found = finest[run.record.variant];
        if (!found || run.record.particle_spacing < found->record.particle_spacing) found = &run;
    }
    for (const auto& [variant, run] : finest) {
        for (const QuantityResult& q : run->quantities) {
            if (!q.expected || !q.tolerance || !is_stated(scene, q.name)) continue;
            StatementResult result{scene.scene, q.expected_source, variant,
                                   fmt::format("{:.4g}", *q.expected), q.name};
            result.dx = run->record.particle_spacing;
            result.value = q.value;
            result.unit = q.unit;
            result.low = *q.expected - *q.tolerance;
            result.high = *q.expected + *q.tolerance;
            result.note = q.note;
            results.push_back(std::move(result));
        }
    }
}

}  // namespace

std::vector<StatementResult> judge_statements(const AnalysisSpec& scene,
                                              const std::vector<RunSummary>& runs) {
    std::vector<StatementResult> results;
    for (const SourceStatement& statement : scene.statements)
        for (std::size_t place = 0; place < statement.variants.size(); ++place)
            results.push_back(judge(statement, place, scene.scene, runs));
    add_stated_values(scene, runs, results);
    return results;
}

const std::vector<std::string>& statement_measure_names() {
    static const std::vector<std::string> names{"difference", "ratio", "curve_difference"};
    return names;
}

}  // namespace wetdeck
