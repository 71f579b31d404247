// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck ablate`: what each ingredient of a scene's model costs and what it improves.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/references.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/jobs/local.hpp"
#include "validation/metrics/ablation.hpp"
#include "validation/metrics/analysis.hpp"
#include "validation/metrics/stored_tables.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/scene/ingredients.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct AblateOptions {
    std::string scene;  ///< name or path
    RunChoice choice;
    std::string directory;
    int jobs = 0;
    bool fresh = false, quiet = false;
};

double coarsest_quick_spacing(const Scene& scene) {
    const auto tier = scene.tiers.find("quick");
    if (tier == scene.tiers.end() || tier->second.count(scene.variant) == 0)
        throw InputError("--dx is missing: the scene names no quick spacing for this variant");
    const std::vector<double>& spacings = tier->second.at(scene.variant);
    return *std::max_element(spacings.begin(), spacings.end());
}

/// The study of one model: its runs, the full model first, and where they lie.
struct Study {
    Scene scene;
    double particle_spacing;
    AblationPlan plan;
    fs::path directory;     ///< of all results
    fs::path full_model;    ///< run directory
    fs::path other_models;  ///< folder of run directories

    Study(const AblateOptions& options, const fs::path& results)
        : scene(read_scene(find_scene(options.scene), options.choice.variant)),
          particle_spacing(options.choice.particle_spacing ? *options.choice.particle_spacing
                                                           : coarsest_quick_spacing(scene)),
          plan(ablation_plan(scene)),
          directory(results),
          full_model(run_path(results, scene.name(), scene.variant, particle_spacing)),
          other_models(results / ablation_folder / full_model.lexically_relative(results / "runs")) {
        check_spacing(scene, particle_spacing);
        check_references(scene);
    }
};

std::vector<SuiteRow> rows_of(const Study& study, const AblateOptions& options) {
    std::vector<SuiteRow> rows;
    const Scene& scene = study.scene;
    const std::optional<double>& until = options.choice.until;
    const double share = std::min(1.0, until.value_or(scene.end_time) / scene.end_time);
    for (const AblationRun& run : study.plan.runs) {
        const Scene varied = read_scene(find_scene(options.scene), scene.variant, run.overrides);
        rows.push_back({options.scene, scene.variant, study.particle_spacing,
                        share * estimate_cost(varied, study.particle_spacing).core_seconds, run.overrides,
                        run.overrides.empty() ? study.full_model : study.other_models / run.name, until});
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

/// What the comparison of a run with an ingredient and a run without it gave.
struct IngredientResult {
    AblationRow row;
    AblationVerdict verdict;
    std::vector<AblationValue> values;
    bool stable_with = true, stable_without = true;
};

IngredientResult result_of(const AblationPair& pair, const Scene& scene, const std::vector<RunSummary>& runs,
                           const std::map<std::string, double>& spreads) {
    const RunSummary &with = runs[pair.with], &without = runs[pair.without];
    IngredientResult result;
    result.stable_with = stable(with);
    result.stable_without = stable(without);
    result.values = ablation_values(with, without, spreads);
    result.verdict = ablation_verdict(result.stable_with, result.stable_without, result.values);
    result.row = {
        scene.name(), with.record.particle_spacing, fmt::format("{}, {}", pair.ingredient, scene.variant), {},
        {},           result.verdict.needed};
    if (!result.stable_with || !result.stable_without) return result;  // cut short: nothing to compare
    if (with.record.cost.core_s > 0)
        result.row.core_s_ratio = without.record.cost.core_s / with.record.cost.core_s;
    for (const AblationValue& value : result.values) {
        if (value.name == scene.analysis.error_quantity && value.expected)
            result.row.error_change = value.change();
    }
    return result;
}

json result_json(const IngredientResult& result) {
    json values = json::array();
    for (const AblationValue& v : result.values) {
        values.push_back({{"name", v.name},
                          {"with", optional_json(v.with)},
                          {"without", optional_json(v.without)},
                          {"expected", optional_json(v.expected)},
                          {"tolerance", optional_json(v.tolerance)},
                          {"spread", optional_json(v.spread)},
                          {"change", optional_json(v.change())}});
    }
    json row = ablation_json(result.row);
    row["stable_with"] = result.stable_with;
    row["stable_without"] = result.stable_without;
    row["reason"] = result.verdict.reason;
    row["values"] = std::move(values);
    return row;
}

/// The three largest changes, each measured in units of the change that would be significant.
std::string largest_changes(const IngredientResult& result) {
    std::vector<std::pair<double, std::string>> changes;
    for (const AblationValue& v : result.values) {
        const std::optional<double> change = v.change();
        if (!change) continue;
        const std::optional<double> unit = v.expected ? v.tolerance : v.spread;
        const double weight = unit && *unit > 0 ? std::abs(*change) / *unit : 0;
        changes.emplace_back(weight, fmt::format("{} {:+.3g}", v.name, *change));
    }
    std::stable_sort(changes.begin(), changes.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string out;
    for (std::size_t k = 0; k < std::min<std::size_t>(changes.size(), 3); ++k)
        out += (k > 0 ? "; " : "") + changes[k].second;
    return out;
}

void print_table(const std::vector<IngredientResult>& table) {
    fmt::print("{:<54} {:>10} {:>10} {:>11}  {}\n", "ingredient", "core s", "error", "verdict",
               "why; changes");
    for (const IngredientResult& j : table) {
        const bool both = j.stable_with && j.stable_without;
        fmt::print("{:<54} {:>10} {:>10} {:>11}  {}{}\n", j.row.ingredient,
                   j.row.core_s_ratio ? fmt::format("x{:.2f}", *j.row.core_s_ratio) : "-",
                   j.row.error_change ? fmt::format("{:+.3g}", *j.row.error_change) : "-",
                   j.verdict.needed ? "needed" : "not shown", j.verdict.reason,
                   both ? "; " + largest_changes(j) : "");
    }
    fmt::print(
        "core s: the run without the ingredient over the run with it; error: without it minus with it\n{}\n",
        ablation_rule);
}

/// Rows of this scene, variant and spacing replace those that the directory holds.
void merge_rows(const Study& study, const std::vector<IngredientResult>& table) {
    std::vector<AblationRow> rows;
    for (AblationRow& row : read_ablation(study.directory)) {
        const bool ours = row.scene == study.scene.name() && row.dx == study.particle_spacing &&
                          row.ingredient.ends_with(", " + study.scene.variant);
        if (!ours) rows.push_back(std::move(row));
    }
    for (const IngredientResult& result : table) rows.push_back(result.row);
    write_ablation(study.directory, rows);
}

/// Refuses a stop time that would replace a run of the full model with another length.
void check_until(const AblateOptions& options, const SuiteRow& full_model) {
    const fs::path& directory = full_model.directory;
    const bool taken = holds_finished_run(directory) || !list_checkpoints(directory).empty();
    if (options.choice.until && taken && !finished(full_model) && !interrupted(full_model))
        throw InputError(
            fmt::format("{}: holds a run of another length, expected --out with another directory, or no "
                        "--until",
                        directory.string()));
}

std::vector<RunSummary> stored_runs(const Scene& scene, const std::vector<SuiteRow>& rows) {
    std::vector<RunSummary> runs;
    for (const SuiteRow& row : rows) {
        if (!finished(row))
            throw InputError(fmt::format("{}: did not finish, see {}", row_name(row),
                                         (row.directory / "run.log").string()));
        runs.push_back(evaluated(scene, row.directory));
    }
    return runs;
}

/// Runs the plan of the scene (ablation_plan) as processes and reuses finished runs: the full model where a
/// suite would store it, the others in DIR/ablation/SCENE/VARIANT/dxDX/. Prints a table, adds the rows to
/// DIR/ablation.json and writes every number to table.json beside the runs.
int ablate(const AblateOptions& options) {
    catch_stop_signals();
    const fs::path directory =
        options.directory.empty() ? fs::path("results") / "quick" : fs::path(options.directory);
    const Study study(options, directory);
    const std::vector<SuiteRow> rows = rows_of(study, options);
    check_until(options, rows.front());
    LocalOptions local{{}, options.jobs, options.quiet};
    local.row.threads = 1;  // threads that wait for each other would blur the cost
    local.row.fresh = options.fresh;
    run_rows(rows, local);

    const std::vector<RunSummary> runs = stored_runs(study.scene, rows);
    const std::map<std::string, double> spreads = discretisation_spreads(
        analyse_directory(directory).convergence, study.scene.name(), study.scene.variant);
    std::vector<IngredientResult> table;
    json all = json::array();
    for (const AblationPair& pair : study.plan.pairs) {
        table.push_back(result_of(pair, study.scene, runs, spreads));
        all.push_back(result_json(table.back()));
    }
    merge_rows(study, table);
    atomic_write(study.other_models / "table.json",
                 json{{"schema", 1}, {"rule", ablation_rule}, {"rows", std::move(all)}}.dump(1) + "\n");
    print_table(table);
    make_report(directory);
    fmt::print("report: {}\n", (directory / "index.html").string());
    return stable(runs.front()) ? exit_done : exit_unstable;
}

}  // namespace

void add_ablate(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<AblateOptions>();
    CLI::App& command = *app.add_subcommand(
        "ablate",
        "leave out one ingredient of a scene's model at a time: what it costs and what it improves");
    add_scene(command, options->scene);
    add_run_choice(command, options->choice, "the coarsest of the quick tier");
    add_out(command, options->directory, "results/quick");
    add_jobs(command, options->jobs);
    add_fresh(command, options->fresh);
    add_quiet(command, options->quiet);
    command.footer(std::string("Verdict: ") + ablation_rule + ".");
    command.callback([options, &exit_code] { exit_code = ablate(*options); });
}

}  // namespace wetdeck
