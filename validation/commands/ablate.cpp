// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/ablate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/commands/report_command.hpp"
#include "validation/metrics/ablation.hpp"
#include "validation/metrics/analysis.hpp"
#include "validation/metrics/stored_tables.hpp"
#include "validation/run/assemble.hpp"
#include "validation/scene/ingredients.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

double coarsest_quick_spacing(const Scene& scene) {
    const auto tier = scene.tiers.find("quick");
    if (tier == scene.tiers.end() || tier->second.count(scene.variant) == 0)
        throw InputError("--dx is missing: the scene names no quick spacing for this variant");
    const std::vector<double>& spacings = tier->second.at(scene.variant);
    return *std::max_element(spacings.begin(), spacings.end());
}

std::vector<SuiteRow> rows_of(const AblationPlan& plan, const Scene& scene, const AblateOptions& options,
                              double dx, const fs::path& full, const fs::path& others) {
    std::vector<SuiteRow> rows;
    for (const AblationRun& run : plan.runs) {
        const Scene varied = read_scene(find_scene(options.scene), scene.variant, run.overrides);
        const double share = std::min(1.0, options.until.value_or(scene.end_time) / scene.end_time);
        rows.push_back({options.scene, scene.variant, dx, share * estimate_cost(varied, dx).core_seconds,
                        run.overrides, run.overrides.empty() ? full : others / run.name, options.until});
    }
    return rows;
}

RunSummary evaluated(const Scene& scene, const fs::path& directory) {
    AnalysisSpec spec = scene.analysis;
    spec.variant = scene.variant;
    RunSummary run;
    run.record = read_run(run_file(directory));
    return analyse({spec}, {std::move(run)}, reference_directory()).runs.front();
}

bool stable(const RunSummary& run) {
    return run.record.status == RunStatus::ok;
}

json optional_json(const std::optional<double>& value) {
    return value ? json(*value) : json(nullptr);
}

/// One pair of runs, judged.
struct Judged {
    AblationRow row;
    AblationVerdict verdict;
    std::vector<AblationValue> values;
    bool stable_with = true, stable_without = true;
};

Judged judge(const AblationPair& pair, const Scene& scene, const std::vector<RunSummary>& runs,
             const std::map<std::string, double>& spreads) {
    const RunSummary &with = runs[pair.with], &without = runs[pair.without];
    Judged judged;
    judged.stable_with = stable(with);
    judged.stable_without = stable(without);
    judged.values = ablation_values(with, without, spreads);
    judged.verdict = ablation_verdict(judged.stable_with, judged.stable_without, judged.values);
    judged.row = {
        scene.name(), with.record.particle_spacing, fmt::format("{}, {}", pair.ingredient, scene.variant), {},
        {},           judged.verdict.needed};
    if (!judged.stable_with || !judged.stable_without) return judged;  // cut short: nothing to compare
    if (with.record.cost.core_s > 0)
        judged.row.core_s_ratio = without.record.cost.core_s / with.record.cost.core_s;
    for (const AblationValue& value : judged.values) {
        if (value.name == scene.analysis.error_quantity && value.expected)
            judged.row.error_change = value.change();
    }
    return judged;
}

json judged_json(const Judged& judged) {
    json values = json::array();
    for (const AblationValue& v : judged.values) {
        values.push_back({{"name", v.name},
                          {"with", optional_json(v.with)},
                          {"without", optional_json(v.without)},
                          {"expected", optional_json(v.expected)},
                          {"tolerance", optional_json(v.tolerance)},
                          {"spread", optional_json(v.spread)},
                          {"change", optional_json(v.change())}});
    }
    json row = ablation_json(judged.row);
    row["stable_with"] = judged.stable_with;
    row["stable_without"] = judged.stable_without;
    row["reason"] = judged.verdict.reason;
    row["values"] = std::move(values);
    return row;
}

/// The numbers that speak loudest: changes in units of what would tell.
std::string changes_text(const Judged& judged) {
    std::vector<std::pair<double, std::string>> told;
    for (const AblationValue& v : judged.values) {
        const std::optional<double> change = v.change();
        if (!change) continue;
        const std::optional<double> unit = v.expected ? v.tolerance : v.spread;
        const double weight = unit && *unit > 0 ? std::abs(*change) / *unit : 0;
        told.emplace_back(weight, fmt::format("{} {:+.3g}", v.name, *change));
    }
    std::stable_sort(told.begin(), told.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string out;
    for (std::size_t k = 0; k < std::min<std::size_t>(told.size(), 3); ++k)
        out += (k > 0 ? "; " : "") + told[k].second;
    return out;
}

void print_table(const std::vector<Judged>& table) {
    fmt::print("{:<54} {:>10} {:>10} {:>11}  {}\n", "ingredient", "core s", "error", "verdict",
               "why; changes");
    for (const Judged& j : table) {
        const bool both = j.stable_with && j.stable_without;
        fmt::print("{:<54} {:>10} {:>10} {:>11}  {}{}\n", j.row.ingredient,
                   j.row.core_s_ratio ? fmt::format("x{:.2f}", *j.row.core_s_ratio) : "-",
                   j.row.error_change ? fmt::format("{:+.3g}", *j.row.error_change) : "-",
                   j.verdict.needed ? "needed" : "not shown", j.verdict.reason,
                   both ? "; " + changes_text(j) : "");
    }
    fmt::print("without it over with it, without it minus with it; {}\n", ablation_rule);
}

/// Rows of this scene, variant and spacing replace those that the directory holds.
void merge_rows(const fs::path& directory, const Scene& scene, double dx, const std::vector<Judged>& table) {
    std::vector<AblationRow> rows;
    for (AblationRow& row : read_ablation(directory)) {
        const bool ours =
            row.scene == scene.name() && row.dx == dx && row.ingredient.ends_with(", " + scene.variant);
        if (!ours) rows.push_back(std::move(row));
    }
    for (const Judged& judged : table) rows.push_back(judged.row);
    write_ablation(directory, rows);
}

}  // namespace

bool run_ablation(const AblateOptions& options, SuiteOptions suite) {
    suite.threads = 1;
    const Scene scene = read_scene(find_scene(options.scene), options.variant);
    const double dx =
        options.particle_spacing != 0 ? options.particle_spacing : coarsest_quick_spacing(scene);
    check_spacing(scene, dx);
    const AblationPlan plan = ablation_plan(scene);
    const fs::path full = run_path(suite.directory, scene.name(), scene.variant, dx);
    const fs::path folder =
        suite.directory / ablation_folder / full.lexically_relative(suite.directory / "runs");
    const std::vector<SuiteRow> rows = rows_of(plan, scene, options, dx, full, folder);
    const bool taken = holds_finished_run(full) || !list_checkpoints(full).empty();
    if (options.until && taken && !finished(rows.front()) && !interrupted(rows.front()))
        throw InputError(
            fmt::format("{}: holds a run of another length, expected --out with another directory, or no "
                        "--until",
                        full.string()));
    run_rows(rows, suite);

    std::vector<RunSummary> runs;
    for (const SuiteRow& row : rows) {
        if (!finished(row))
            throw InputError(
                fmt::format("{}: did not end, see {}", row_name(row), (row.directory / "run.log").string()));
        runs.push_back(evaluated(scene, row.directory));
    }
    const std::map<std::string, double> spreads =
        discretisation_spreads(analyse_directory(suite.directory).convergence, scene.name(), scene.variant);
    std::vector<Judged> table;
    json all = json::array();
    for (const AblationPair& pair : plan.pairs) {
        table.push_back(judge(pair, scene, runs, spreads));
        all.push_back(judged_json(table.back()));
    }
    merge_rows(suite.directory, scene, dx, table);
    atomic_write(folder / "table.json",
                 json{{"schema", 1}, {"rule", ablation_rule}, {"rows", std::move(all)}}.dump(1) + "\n");
    print_table(table);
    make_report(suite.directory);
    return stable(runs.front());
}

}  // namespace wetdeck
