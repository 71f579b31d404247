// SPDX-License-Identifier: BSD-3-Clause
// From stored runs to everything the report shows.
#include "validation/metrics/analysis.hpp"

#include <iterator>
#include <map>

#include "validation/metrics/compare.hpp"
#include "validation/metrics/conservation.hpp"
#include "validation/metrics/convergence.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/metrics/speed_error.hpp"

namespace wetdeck {
namespace {

void evaluate_run(const AnalysisSpec& spec, RunSummary& run, ReferenceShelf& references) {
    for (const QuantitySpec& quantity : spec.quantities) {
        run.quantities.push_back(evaluate_quantity(quantity, run.record, references));
    }
    for (const ComparisonSpec& comparison : spec.comparisons) {
        run.comparisons.push_back(compare(comparison, run.record, references));
    }
}

/// One row per variant and quantity that at least one sound run has a value for.
void add_convergence(const AnalysisSpec& spec, Summary& summary) {
    using Values = std::map<double, double>;  // by spacing, so that a spacing counts once
    std::map<std::string, std::map<std::string, Values>> variants;
    for (const RunSummary& run : summary.runs) {
        if (run.record.scene != spec.scene || run.record.status != RunStatus::ok) continue;
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

}  // namespace

Summary analyse(const std::vector<AnalysisSpec>& scenes, std::vector<RunSummary> runs,
                const std::filesystem::path& reference_directory) {
    Summary summary;
    summary.scenes = scenes;
    summary.runs = std::move(runs);
    for (RunSummary& run : summary.runs) {
        run.energy_error = energy_error(run.record);
        run.momentum_error = momentum_error(run.record);
    }
    for (const AnalysisSpec& spec : scenes) {
        ReferenceShelf references(reference_directory / spec.scene);
        for (RunSummary& run : summary.runs) {
            if (run.record.scene == spec.scene) evaluate_run(spec, run, references);
        }
        add_convergence(spec, summary);
        if (spec.error_quantity.empty()) continue;
        auto points = speed_error_points(summary.runs, spec.scene, spec.error_quantity);
        std::move(points.begin(), points.end(), std::back_inserter(summary.speed_error));
    }
    return summary;
}

}  // namespace wetdeck
