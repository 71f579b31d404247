// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/analysis.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "validation/metrics/compare.hpp"
#include "validation/metrics/conservation.hpp"
#include "validation/metrics/convergence.hpp"
#include "validation/metrics/curve_convergence.hpp"
#include "validation/metrics/energy_budget.hpp"
#include "validation/metrics/flow_flags.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/metrics/reference_use.hpp"
#include "validation/metrics/replicates.hpp"
#include "validation/metrics/resample.hpp"
#include "validation/metrics/sound_speed.hpp"
#include "validation/metrics/speed_error.hpp"
#include "validation/metrics/statements.hpp"
#include "validation/metrics/statistics.hpp"
#include "validation/metrics/time_origin.hpp"
#include "validation/metrics/validation.hpp"

namespace wetdeck {
namespace {

void evaluate_run(const AnalysisSpec& spec, RunSummary& run, ReferenceShelf& references) {
    run.expected_unstable = spec.expected_unstable;
    for (const QuantitySpec& quantity : spec.quantities) {
        run.quantities.push_back(evaluate_quantity(quantity, run.record, references));
    }
    for (const ComparisonSpec& comparison : spec.comparisons) {
        ComparisonResult result = compare(comparison, run.record, references);
        if (stopped_early(run.record) && !result.nrmse) result.available = false;
        run.comparisons.push_back(std::move(result));
    }
}

void add_doubts(const AnalysisSpec& spec, const RunRecord& record, std::vector<RunDoubt>& doubts) {
    const auto add = [&](RunDoubt::About about, const std::string& sentence) {
        doubts.push_back({about, record.scene, record.variant, record.particle_spacing,
                          provenance_entry(record, "overrides"), sentence});
    };
    for (const std::string& sentence : doubtful_origins(spec, record))
        add(RunDoubt::About::time_origin, sentence);
    if (!spec.expected_unstable)
        for (const std::string& sentence : flow_flags(record)) add(RunDoubt::About::flow, sentence);
}

/// One row per variant and quantity that at least one sound run has a value for.
void add_convergence(const AnalysisSpec& spec, Summary& summary) {
    using Values = std::map<double, double>;  // by spacing, so that a spacing counts once
    std::map<std::string, std::map<std::string, Values>> variants;
    for (const RunSummary& run : summary.runs) {
        if (!applies(spec, run.record) || !counts(run)) continue;
        for (const QuantityResult& quantity : run.quantities) {
            if (!quantity.value) continue;
            variants[run.record.variant][quantity.name][run.record.particle_spacing] = *quantity.value;
        }
    }
    for (const auto& [variant, quantities] : variants) {
        for (const auto& [name, values] : quantities) {
            ConvergenceRow row = convergence({values.begin(), values.end()});
            row.scene = spec.scene;
            row.variant = variant;
            row.qoi = name;
            summary.convergence.push_back(std::move(row));
        }
    }
}

/// Scaling and window of a series are those of its first comparison.
void add_curve_convergence(const AnalysisSpec& spec, Summary& summary) {
    std::set<std::string> seen;
    for (const ComparisonSpec& comparison : spec.comparisons) {
        if (!seen.insert(comparison.quantity).second) continue;
        std::map<std::string, std::map<double, Curve>> variants;
        for (const RunSummary& run : summary.runs) {
            if (!applies(spec, run.record) || !counts(run)) continue;
            SeriesCurve series = compared_series(comparison, run.record);
            if (series.problem.empty())
                variants[run.record.variant][run.record.particle_spacing] = std::move(series.curve);
        }
        for (const auto& [variant, curves] : variants) {
            const Window window = comparison.window.value_or(extent(curves.begin()->second));
            CurveConvergenceRow row = curve_convergence({curves.begin(), curves.end()}, window);
            row.scene = spec.scene;
            row.variant = variant;
            row.series = comparison.quantity;
            summary.curve_convergence.push_back(std::move(row));
        }
    }
}

/// One specification per scene, with the quantities and comparisons of all its variants, those of the default
/// variant first.
std::vector<AnalysisSpec> merged(std::vector<AnalysisSpec> specifications) {
    std::stable_sort(specifications.begin(), specifications.end(), [](const auto& a, const auto& b) {
        return std::tuple(a.scene, a.variant != a.default_variant) <
               std::tuple(b.scene, b.variant != b.default_variant);
    });
    std::vector<AnalysisSpec> scenes;
    for (AnalysisSpec& spec : specifications) {
        if (scenes.empty() || scenes.back().scene != spec.scene) {
            spec.variant.clear();
            scenes.push_back(std::move(spec));
            continue;
        }
        AnalysisSpec& scene = scenes.back();
        for (QuantitySpec& quantity : spec.quantities) {
            const bool known = std::any_of(scene.quantities.begin(), scene.quantities.end(),
                                           [&](const QuantitySpec& q) { return q.name == quantity.name; });
            if (!known) scene.quantities.push_back(std::move(quantity));
        }
        for (ComparisonSpec& comparison : spec.comparisons) {
            const auto same = [&](const ComparisonSpec& c) {
                return c.title == comparison.title && c.quantity == comparison.quantity &&
                       c.reference == comparison.reference;
            };
            if (std::none_of(scene.comparisons.begin(), scene.comparisons.end(), same))
                scene.comparisons.push_back(std::move(comparison));
        }
    }
    return scenes;
}

template <typename Item>
void append(std::vector<Item>& all, std::vector<Item> some) {
    std::move(some.begin(), some.end(), std::back_inserter(all));
}

}  // namespace

Summary analyse(const std::vector<AnalysisSpec>& scenes, std::vector<RunSummary> runs,
                const std::filesystem::path& reference_directory,
                std::vector<SensitivityRun> sensitivity_runs) {
    Summary summary;
    summary.scenes = merged(scenes);
    summary.runs = std::move(runs);
    for (RunSummary& run : summary.runs) {
        run.energy_error = energy_error(run.record);
        run.momentum_error = momentum_error(run.record);
        add_energy_loss(run.record);
    }
    for (SensitivityRun& varied : sensitivity_runs) add_energy_loss(varied.run.record);
    for (const AnalysisSpec& spec : scenes) {
        ReferenceShelf references(reference_directory / spec.scene, spec.folder);
        for (RunSummary& run : summary.runs) {
            if (!applies(spec, run.record)) continue;
            evaluate_run(spec, run, references);
            add_doubts(spec, run.record, summary.doubts);
        }
        for (SensitivityRun& varied : sensitivity_runs) {
            if (!applies(spec, varied.run.record)) continue;
            evaluate_run(spec, varied.run, references);
            add_doubts(spec, varied.run.record, summary.doubts);
        }
        add_convergence(spec, summary);
        add_curve_convergence(spec, summary);
        append(summary.sensitivity, sensitivity_rows(spec, sensitivity_runs));
        append(summary.replicates, replicate_rows(spec, sensitivity_runs));
        append(summary.sound_speed,
               sound_speed_rows(spec, sensitivity_runs, summary.runs, summary.convergence));
        append(summary.scatter, scatter_points(spec, summary.runs));
    }
    const InputStudies studies{summary.sensitivity, summary.replicates};
    for (const AnalysisSpec& spec : scenes) {  // variants take u_input from studies of others
        JudgedRows judged = judged_rows(spec, summary.runs, studies);
        append(summary.validation, std::move(judged.validation));
        append(summary.agreement, std::move(judged.agreement));
    }
    for (AnalysisSpec& spec : summary.scenes) {
        ReferenceShelf references(reference_directory / spec.scene, spec.folder);
        find_source_curves(spec, reference_directory / spec.scene);
        append(summary.cheapest, cheapest_rows(summary.runs, spec));
        append(summary.peers, peer_points(spec, references));
        append(summary.statements, judge_statements(spec, summary.runs));
        if (spec.error_quantity.empty()) continue;
        append(summary.speed_error, speed_error_points(summary.runs, spec, summary.convergence));
    }
    count_each_once(summary.scatter);
    summary.statistics = class_statistics(summary.scatter);
    return summary;
}

}  // namespace wetdeck
