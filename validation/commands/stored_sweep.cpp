// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/stored_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/page/report_inputs.hpp"
#include "reports/sweep_report.hpp"
#include "validation/jobs/sweep.hpp"
#include "validation/metrics/analysis.hpp"
#include "validation/metrics/convergence.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/provenance.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

/// The stored runs of one point, coarse to fine.
std::vector<RunSummary> runs_at(const SweepPlan& plan, const fs::path& folder) {
    std::vector<RunSummary> runs;
    for (const double dx : plan.spacings) {
        const fs::path directory = folder / fmt::format("dx{}", dx);
        if (!holds_finished_run(directory)) continue;
        RunSummary run;
        run.record = read_run(run_file(directory));
        run.directory = fs::relative(directory, plan.directory).string();
        runs.push_back(std::move(run));
    }
    return runs;
}

/// What the finest run that reached its end says of a quantity, and all of them of its uncertainty.
SweepQuantity quantity_at(const QuantitySpec& spec, const Summary& summary) {
    SweepQuantity q{spec.name, spec.unit, {}, "", {}, spec.expected, spec.tolerance, spec.lines, spec.curve};
    for (const RunSummary& run : summary.runs) {
        if (!counts(run)) continue;
        for (const QuantityResult& result : run.quantities) {
            if (result.name != spec.name) continue;
            q.value = result.value;
            q.note = result.note;
        }
    }
    for (const ConvergenceRow& row : summary.convergence)
        if (row.qoi == spec.name && row.value.size() > 2) q.u_num = numerical_uncertainty(row);
    return q;
}

/// What the page says of the whole, from the first point and the first run at the finest spacing.
void describe(const SweepPlan& plan, const AnalysisSpec& spec, const Summary& summary, SweepResult& result) {
    if (result.scene.empty()) {
        result.scene = spec.scene;
        result.title = spec.title;
        result.purpose = spec.purpose;
        for (const QuantitySpec& quantity : spec.quantities)
            if (result.expected_source.empty()) result.expected_source = quantity.expected_source;
    }
    for (const RunSummary& run : summary.runs) {
        if (!result.provenance.empty() || run.record.particle_spacing != plan.spacings.back()) continue;
        for (const char* name : {"program_version", "commit", "compiler", "simd", "cpu"})
            result.provenance.emplace_back(name, provenance_entry(run.record, name));
    }
}

void add_point(const SweepPlan& plan, const std::vector<double>& at, SweepResult& result) {
    const fs::path folder = point_directory(plan, at);
    std::vector<RunSummary> runs = runs_at(plan, folder);
    SweepPoint point{at, "missing", fs::relative(folder, plan.directory).string(), {}};
    const std::vector<std::string> overrides = overrides_at(plan, at);
    Scene scene = runs.empty() ? read_scene(find_scene(plan.scene), plan.variant, overrides)
                               : parse_scene(runs.back().record.scene_text, runs.back().record.scene_path,
                                             plan.variant, overrides);
    scene.analysis.variant = plan.variant;
    const std::size_t present = runs.size();
    const Summary summary = analyse({scene.analysis}, std::move(runs), reference_directory());
    for (const RunSummary& run : summary.runs) {
        point.core_seconds += run.record.cost.core_s;
        if (counts(run)) point.dx.push_back(run.record.particle_spacing);
    }
    if (present == plan.spacings.size()) point.status = to_string(summary.runs.back().record.status);
    for (const QuantitySpec& spec : scene.analysis.quantities)
        point.quantities.push_back(quantity_at(spec, summary));
    describe(plan, scene.analysis, summary, result);
    result.points.push_back(std::move(point));
}

}  // namespace

bool holds_sweep(const fs::path& directory) {
    return fs::is_regular_file(directory / sweep_file);
}

SweepResult make_sweep_report(const fs::path& directory, bool single_file) {
    const SweepPlan plan = read_sweep_plan(directory);
    SweepResult result;
    result.variant = plan.variant;
    result.axes = plan.axes;
    for (const std::vector<double>& at : grid_points(plan.axes)) add_point(plan, at, result);
    atomic_write(directory / "sweep.csv", sweep_csv(result));
    report::ReportInputs inputs;
    inputs.plotly = report::load_plotly();
    inputs.single_file = single_file;
    report::write_sweep_report(directory, result, inputs);
    return result;
}

int print_sweep(const SweepResult& result, const fs::path& directory) {
    fmt::print("table: {}\nreport: {}\n", (directory / "sweep.csv").string(),
               (directory / "index.html").string());
    const auto with_status = [&result](const char* status) {
        return std::count_if(result.points.begin(), result.points.end(),
                             [status](const SweepPoint& point) { return point.status == status; });
    };
    if (const auto missing = with_status("missing"); missing > 0)
        fmt::print("{} of {} points are incomplete\n", missing, result.points.size());
    const auto unstable = with_status("unstable");
    if (unstable > 0) fmt::print("{} of {} points became unstable\n", unstable, result.points.size());
    std::size_t outside = 0;
    for (const SweepPoint& point : result.points)
        for (const SweepQuantity& q : point.quantities)
            if (q.value && q.expected && std::abs(*q.value - *q.expected) > *q.tolerance) ++outside;
    if (outside > 0) fmt::print("outside tolerance: {} values, see the report\n", outside);
    return unstable > 0 ? exit_unstable : outside > 0 ? exit_outside : exit_done;
}

}  // namespace wetdeck
