// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/stored_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <list>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "reports/figures/selection.hpp"
#include "reports/report.hpp"
#include "solver/core/errors.hpp"
#include "solver/passes/pair_passes.hpp"
#include "validation/commands/pictures.hpp"
#include "validation/commands/sketch.hpp"
#include "validation/jobs/plan.hpp"
#include "validation/metrics/analysis.hpp"
#include "validation/metrics/peer_result.hpp"
#include "validation/metrics/stored_tables.hpp"
#include "validation/metrics/summary_json.hpp"
#include "validation/metrics/verification_json.hpp"
#include "validation/scene/one_setup.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/scheme_differences.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/environment.hpp"
#include "validation/store/provenance.hpp"
#include "validation/store/run_store.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

/// Every run.h5 below a directory, in a fixed order.
std::vector<RunSummary> runs_below(const fs::path& directory, const fs::path& root) {
    std::vector<RunSummary> runs;
    std::error_code error;
    if (!fs::is_directory(directory, error)) return runs;
    for (const auto& entry :
         fs::recursive_directory_iterator(directory, fs::directory_options::skip_permission_denied)) {
        if (entry.path().filename() != "run.h5" || !entry.is_regular_file()) continue;
        RunSummary run;
        run.record = read_run(entry.path());
        run.directory = fs::relative(entry.path().parent_path(), root).string();
        runs.push_back(std::move(run));
    }
    std::sort(runs.begin(), runs.end(), [](const RunSummary& a, const RunSummary& b) {
        return std::tuple(a.record.scene, a.record.variant, -a.record.particle_spacing, a.directory) <
               std::tuple(b.record.scene, b.record.variant, -b.record.particle_spacing, b.directory);
    });
    return runs;
}

bool lies_in(const RunSummary& run, const char* folder) {
    return *fs::path(run.directory).begin() == folder;
}

bool in_study(const RunSummary& run) {
    return lies_in(run, sensitivity_folder) || lies_in(run, sound_speed_folder) ||
           lies_in(run, replicates_folder);
}

/// What every stored run of the directory is: a row of the tier, or of a study of one input.
struct StoredRuns {
    std::vector<RunSummary> runs;
    std::vector<SensitivityRun> varied;
};

StoredRuns read_runs(const fs::path& directory) {
    std::error_code error;
    if (!fs::is_directory(directory, error))
        throw InputError(fmt::format("{}: no such directory", directory.string()));
    StoredRuns stored;
    for (RunSummary& run : runs_below(directory, directory)) {
        if (lies_in(run, ablation_folder)) continue;
        if (!in_study(run)) {
            stored.runs.push_back(std::move(run));
            continue;
        }
        const std::string assignment = run.record.provenance["overrides"];
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos)
            throw DataError(fmt::format("{}: a run of a study of one input without the key it varies",
                                        (directory / run.directory).string()));
        stored.varied.push_back({assignment.substr(0, equals),
                                 std::strtod(assignment.c_str() + equals + 1, nullptr), std::move(run)});
    }
    if (stored.runs.empty() && !fs::exists(directory / verification_file) &&
        !fs::exists(directory / stress_file))
        throw InputError(fmt::format("{}: holds no run.h5, expected the directory of a suite or a run",
                                     directory.string()));
    return stored;
}

/// A scene as the run saw it. Later runs of the same scene speak for it.
std::map<std::string, Scene> scenes_of(const std::vector<RunSummary>& runs) {
    std::map<std::string, Scene> scenes;
    for (const RunSummary& run : runs) {
        scenes.insert_or_assign(run.record.scene, parse_scene(run.record.scene_text, run.record.scene_path));
    }
    return scenes;
}

/// How the schemes of the variants that were run differ from that of the scene's source.
std::vector<report::SchemeRow> scheme_rows(const Scene& scene, const std::vector<RunSummary>& runs) {
    std::vector<report::SchemeRow> rows;
    std::set<std::string> done;
    for (const RunSummary& run : runs) {
        const RunRecord& r = run.record;
        if (r.scene != scene.name() || !done.insert(r.variant).second) continue;
        for (SchemeDifference& d : scheme_differences(parse_scene(r.scene_text, r.scene_path, r.variant)))
            rows.push_back({r.variant, d.key, d.meaning, d.equation, d.source, d.used});
    }
    return rows;
}

/// What each variant asks of its runs, as the latest of them saw it.
std::vector<AnalysisSpec> specifications_of(const std::vector<RunSummary>& runs) {
    std::map<std::pair<std::string, std::string>, AnalysisSpec> specifications;
    for (const RunSummary& run : runs) {
        const RunRecord& r = run.record;
        AnalysisSpec spec = parse_scene(r.scene_text, r.scene_path, r.variant).analysis;
        spec.variant = r.variant;
        specifications.insert_or_assign({r.scene, r.variant}, std::move(spec));
    }
    std::vector<AnalysisSpec> all;
    for (auto& entry : specifications) all.push_back(std::move(entry.second));
    return all;
}

ProgramInfo program_info(const std::vector<RunSummary>& runs) {
    std::map<std::string, std::string> c;
    if (runs.empty()) {  // verification alone: this program ran it
        collect_provenance(pair_passes(Model{}, instruction_set_from_environment()).instruction_set, 1)
            .add_to(c);
    } else {
        c = runs.front().record.provenance;
    }
    const auto get = [&c](const char* key) {
        const auto found = c.find(key);
        return found == c.end() ? std::string("unknown") : found->second;
    };
    ProgramInfo info;
    info.version = get("program_version");
    info.commit = get("commit");
    info.compiler = get("compiler");
    info.simd = get("simd");
    info.threads = std::atoi(get("threads").c_str());
    info.cpu = get("cpu");
    info.cores = std::atoi(get("cores").c_str());
    return info;
}

void read_suite_plan(const fs::path& directory, const std::set<std::string>& present, Summary& summary) {
    std::ifstream in(directory / "suite.json");
    if (!in) {
        const bool verification = fs::exists(directory / verification_file);
        summary.tier = !summary.runs.empty() ? "single runs" : verification ? "verification" : "hard cases";
        return;
    }
    const nlohmann::json plan = nlohmann::json::parse(in, nullptr, false);
    if (!plan.is_object() || !plan.contains("tier") || !plan.contains("runs")) {
        throw DataError(fmt::format("{}: expected an object with 'tier' and 'runs'",
                                    (directory / "suite.json").string()));
    }
    summary.tier = plan.at("tier").get<std::string>();
    for (const auto& planned : plan.at("runs")) {
        const std::string path = planned.get<std::string>();
        if (present.count(path) == 0) summary.missing.push_back(path);
    }
}

/// Of each scene and variant the finest.
report::Runs finest_runs(const Summary& summary) {
    report::Runs all;
    for (const AnalysisSpec& scene : report::scenes_of(summary)) {
        for (const RunSummary* run : report::finest_of_each(report::runs_of(summary, scene)))
            all.push_back(run);
    }
    return all;
}

/// Pictures of the variants that a scene wants beside each other. The set-up of each is that of its variant.
void add_side_by_side(const AnalysisSpec& spec, const Summary& summary, const fs::path& directory,
                      report::ReportInputs& inputs) {
    for (const SideBySide& entry : spec.side_by_side) {
        if (!entry.time) continue;
        std::list<Scene> scenes;  // which the sources refer to
        std::vector<PictureSource> runs;
        for (const RunSummary* run : report::side_by_side_runs(report::runs_of(summary, spec), entry)) {
            const RunRecord& r = run->record;
            scenes.push_back(parse_scene(r.scene_text, r.scene_path, r.variant));
            runs.push_back({scenes.back(), r, directory / run->directory});
        }
        inputs.side_by_side[{spec.scene, entry.title}] = field_pictures_at(runs, *entry.time);
    }
}

}  // namespace

void write_suite_plan(const fs::path& directory, const std::string& tier,
                      const std::vector<std::string>& run_directories) {
    make_directories(directory);
    const nlohmann::json plan = {{"tier", tier}, {"runs", run_directories}};
    atomic_write(directory / "suite.json", plan.dump(2) + "\n");
}

Summary analyse_directory(const fs::path& directory) {
    StoredRuns stored = read_runs(directory);
    std::vector<LeftOutRun> left_out = leave_out_other_setups(stored.runs, stored.varied);
    std::set<std::string> present;
    for (const RunSummary& run : stored.runs) present.insert(run.directory);
    for (const SensitivityRun& varied : stored.varied) present.insert(varied.run.directory);
    const std::vector<AnalysisSpec> specifications = specifications_of(stored.runs);
    Summary summary =
        analyse(specifications, std::move(stored.runs), reference_directory(), std::move(stored.varied));
    summary.left_out = std::move(left_out);
    read_suite_plan(directory, present, summary);
    summary.ablation = read_ablation(directory);
    summary.stress = read_stress(directory);
    summary.verification = read_verification(directory / verification_file);
    return summary;
}

Summary make_report(const fs::path& directory, bool single_file) {
    Summary summary = analyse_directory(directory);
    const std::map<std::string, Scene> scenes = scenes_of(summary.runs);
    const ProgramInfo program = program_info(summary.runs);

    report::ReportInputs inputs;
    inputs.program = {{"version", program.version},
                      {"commit", program.commit},
                      {"compiler", program.compiler},
                      {"instruction set", program.simd}};
    inputs.machine = {{"cpu", program.cpu}, {"cores", std::to_string(program.cores)}};
    inputs.codes = peer_agreement(read_peer_results(directory), summary.runs);
    inputs.plotly = report::load_plotly();
    inputs.single_file = single_file;
    inputs.note = "Made from the stored runs alone by `wetdeck report`.";
    if (!fs::exists(directory / "suite.json")) inputs.subject = summary.tier;
    for (const auto& [name, scene] : scenes) {
        inputs.sketches[name] = sketch(scene).svg();
        inputs.schemes[name] = scheme_rows(scene, summary.runs);
    }
    for (const StressRow& row : summary.stress) {
        const std::filesystem::path picture = directory / row.picture;
        if (std::filesystem::is_regular_file(picture))
            inputs.instabilities[row.picture] = read_whole_file(picture);
    }
    for (const RunSummary* run : finest_runs(summary)) {
        inputs.pictures[run->directory] =
            field_pictures({scenes.at(run->record.scene), run->record, directory / run->directory});
    }
    for (const AnalysisSpec& spec : report::scenes_of(summary))
        add_side_by_side(spec, summary, directory, inputs);
    Summary with_codes = summary;
    with_codes.agreement.insert(with_codes.agreement.end(), inputs.codes.begin(), inputs.codes.end());
    atomic_write(directory / "summary.json", summary_json(with_codes, program).dump(1) + "\n");
    report::write_report(directory, summary, inputs);
    return summary;
}

std::vector<std::string> unusable_curves(const Summary& summary) {
    std::set<std::string> curves;
    for (const RunSummary& run : summary.runs)
        for (const ComparisonResult& c : run.comparisons)
            if (c.unusable) curves.insert(fmt::format("comparison '{}' is left out: {}", c.title, c.note));
    return {curves.begin(), curves.end()};
}

std::vector<std::string> outside_tolerance(const Summary& summary) {
    std::vector<std::string> outside;
    for (const VerificationProblem& problem : summary.verification) {
        if (!problem.unstable.empty()) outside.push_back(problem.name + ": a run became unstable");
        for (const VerificationRow& row : problem.rows) {
            if (!row.within) outside.push_back(fmt::format("{}: {}", problem.name, row.claim.quantity));
        }
    }
    for (const RunSummary* run : finest_runs(summary)) {
        if (run->expected_unstable) continue;
        const auto add = [&](const std::string& name) {
            outside.push_back(fmt::format("{} {} dx {}: {}", run->record.scene, run->record.variant,
                                          run->record.particle_spacing, name));
        };
        for (const QuantityResult& q : run->quantities) {
            if (q.within && !*q.within) add(q.name);
        }
        for (const ComparisonResult& c : run->comparisons) {
            if (c.available && c.judged && !c.within) add(c.title);
        }
    }
    return outside;
}

}  // namespace wetdeck
