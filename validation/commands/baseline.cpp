// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/baseline.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/metrics/resample.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Written into a new baseline, to be narrowed or widened there with a reason. The same program on the same
/// instruction set gives the same bits; on another, rounding differs and the difference grows where water
/// splashes, so only a larger deviation is a regression.
constexpr double default_tolerance = 0.05;  // of the value; of the range of a curve
constexpr int instants = 101;

std::string run_name(const RunRecord& record) {
    return fmt::format("{} {} dx {}", record.scene, record.variant, record.particle_spacing);
}

void require_clean(const RunRecord& record) {
    const auto commit = record.provenance.find("commit");
    const std::string revision = commit == record.provenance.end() ? "unknown" : commit->second;
    if (revision == "unknown" || revision.ends_with("-dirty"))
        throw InputError(fmt::format("{}: made by revision {}, a baseline needs runs of a committed program",
                                     run_name(record), revision));
}

std::vector<double> sampled(const Curve& curve, const Window& window) {
    std::vector<double> values;
    for (int i = 0; i < instants; ++i)
        values.push_back(
            interpolate(curve, std::lerp(window.begin, window.end, static_cast<double>(i) / (instants - 1))));
    return values;
}

json quantities_json(const RunSummary& run) {
    json all = json::object();
    for (const QuantityResult& q : run.quantities) {
        if (!q.value) continue;
        const double tolerance = default_tolerance * std::max(std::abs(*q.value), q.tolerance.value_or(0));
        all[q.name] = {{"value", *q.value}, {"tolerance", tolerance}};
    }
    return all;
}

/// The simulated curves, each series once, on the axes of its first comparison.
json curves_json(const RunSummary& run) {
    json all = json::object();
    for (const ComparisonResult& c : run.comparisons) {
        if (all.contains(c.quantity) || c.simulated.x.size() < 2) continue;
        const auto window = overlap(c.simulated, c.window.value_or(extent(c.simulated)));
        if (!window) continue;
        all[c.quantity] = {{"window", {window->begin, window->end}},
                           {"values", sampled(c.simulated, *window)},
                           {"tolerance", default_tolerance}};
    }
    return all;
}

json read_baseline(const fs::path& file) {
    std::ifstream in(file);
    if (!in) throw InputError(fmt::format("{}: no such baseline", file.string()));
    json baseline = json::parse(in, nullptr, false);
    if (!baseline.is_object() || baseline.value("schema", json()) != 1 || !baseline.contains("runs"))
        throw DataError(fmt::format("{}: expected a baseline of schema 1", file.string()));
    return baseline;
}

const RunSummary* run_like(const Summary& summary, const json& wanted) {
    for (const RunSummary& run : summary.runs) {
        const RunRecord& r = run.record;
        if (r.scene == wanted.at("scene") && r.variant == wanted.at("variant") &&
            r.particle_spacing == wanted.at("dx"))
            return &run;
    }
    return nullptr;
}

void compare_quantities(const RunSummary& run, const json& wanted, std::vector<std::string>& out) {
    for (const auto& [name, entry] : wanted.items()) {
        const auto found = std::find_if(run.quantities.begin(), run.quantities.end(),
                                        [&, key = name](const auto& q) { return q.name == key; });
        const double before = entry.at("value"), tolerance = entry.at("tolerance");
        if (found == run.quantities.end() || !found->value) {
            out.push_back(
                fmt::format("{}: {} was {:.6g}, is no longer computed", run_name(run.record), name, before));
        } else if (!(std::abs(*found->value - before) <= tolerance)) {
            out.push_back(fmt::format("{}: {} was {:.6g} ± {:.2g}, is {:.6g}", run_name(run.record), name,
                                      before, tolerance, *found->value));
        }
    }
}

void compare_curves(const RunSummary& run, const json& wanted, std::vector<std::string>& out) {
    for (const auto& [name, entry] : wanted.items()) {
        const auto found = std::find_if(run.comparisons.begin(), run.comparisons.end(),
                                        [&, key = name](const auto& c) { return c.quantity == key; });
        const Window window{entry.at("window").at(0), entry.at("window").at(1)};
        const auto before = entry.at("values").get<std::vector<double>>();
        if (found == run.comparisons.end() || !covers(found->simulated, window)) {
            out.push_back(fmt::format("{}: curve {} does not cover {:.4g} to {:.4g}", run_name(run.record),
                                      name, window.begin, window.end));
            continue;
        }
        const std::vector<double> now = sampled(found->simulated, window);
        double sum = 0;
        for (std::size_t i = 0; i < before.size() && i < now.size(); ++i)
            sum += (now[i] - before[i]) * (now[i] - before[i]);
        const auto [low, high] = std::minmax_element(before.begin(), before.end());
        const double rms = std::sqrt(sum / instants),
                     bound = entry.at("tolerance").get<double>() * (*high - *low);
        if (!(rms <= bound))
            out.push_back(fmt::format("{}: curve {} is off by {:.3g} rms, tolerance {:.3g}",
                                      run_name(run.record), name, rms, bound));
    }
}

json verdicts_json(const Summary& summary) {
    json all = json::array();
    for (const ValidationRow& row : summary.validation)
        all.push_back({{"scene", row.scene},
                       {"variant", row.variant},
                       {"quantity", row.quantity},
                       {"verdict", row.verdict}});
    return all;
}

/// A verdict that turned, or that is gone.
void compare_verdicts(const Summary& summary, const json& wanted, std::vector<std::string>& out) {
    for (const json& entry : wanted) {
        const auto found =
            std::find_if(summary.validation.begin(), summary.validation.end(), [&](const ValidationRow& row) {
                return row.scene == entry.at("scene") && row.variant == entry.at("variant") &&
                       row.quantity == entry.at("quantity");
            });
        const std::string before = entry.at("verdict");
        const std::string now = found == summary.validation.end() ? "missing" : found->verdict;
        if (now == before) continue;
        out.push_back(fmt::format(
            "{} {}: the verdict on {} was '{}', is '{}'", entry.at("scene").get<std::string>(),
            entry.at("variant").get<std::string>(), entry.at("quantity").get<std::string>(), before, now));
    }
}

}  // namespace

void write_baseline(const fs::path& directory, const fs::path& file, bool replace) {
    if (fs::exists(file) && !replace)
        throw InputError(
            fmt::format("{}: exists already, expected --replace or another file", file.string()));
    const Summary summary = analyse_directory(directory);
    json runs = json::array();
    std::set<std::string> revisions;
    for (const RunSummary& run : summary.runs) {
        if (run.record.status != RunStatus::ok) continue;
        require_clean(run.record);
        revisions.insert(run.record.provenance.at("commit"));
        runs.push_back({{"scene", run.record.scene},
                        {"variant", run.record.variant},
                        {"dx", run.record.particle_spacing},
                        {"quantities", quantities_json(run)},
                        {"curves", curves_json(run)}});
    }
    if (runs.empty()) throw InputError(fmt::format("{}: no run finished", directory.string()));
    const json baseline{{"schema", 1},
                        {"tier", summary.tier},
                        {"revisions", revisions},
                        {"runs", std::move(runs)},
                        {"verdicts", verdicts_json(summary)}};
    if (file.has_parent_path()) make_directories(file.parent_path());
    atomic_write(file, baseline.dump(1) + "\n");
}

std::vector<std::string> compare_with_baseline(const fs::path& directory, const fs::path& file) {
    const json baseline = read_baseline(file);
    const Summary summary = analyse_directory(directory);
    std::vector<std::string> deviations;
    try {
        for (const json& wanted : baseline.at("runs")) {
            const RunSummary* run = run_like(summary, wanted);
            if (run == nullptr || run->record.status != RunStatus::ok) {
                deviations.push_back(fmt::format("{} {} dx {}: {}", wanted.at("scene").get<std::string>(),
                                                 wanted.at("variant").get<std::string>(),
                                                 wanted.at("dx").get<double>(),
                                                 run == nullptr ? "missing" : "did not reach its end"));
                continue;
            }
            compare_quantities(*run, wanted.at("quantities"), deviations);
            compare_curves(*run, wanted.at("curves"), deviations);
        }
        if (baseline.contains("verdicts")) compare_verdicts(summary, baseline.at("verdicts"), deviations);
    } catch (const json::exception& error) {
        throw DataError(fmt::format("{}: {}", file.string(), error.what()));
    }
    return deviations;
}

namespace {

struct BaselineOptions {
    std::string action, directory, file;
    bool replace = false, json = false;
};

int compare(const BaselineOptions& options) {
    const std::vector<std::string> deviations = compare_with_baseline(options.directory, options.file);
    if (options.json) {
        const json all = {{"baseline", options.file}, {"deviations", deviations}};
        fmt::print("{}\n", all.dump(1));
    } else {
        for (const std::string& line : deviations) fmt::print("{}\n", line);
        fmt::print("{} deviations from {}\n", deviations.size(), options.file);
    }
    return deviations.empty() ? exit_done : exit_outside;
}

int baseline(const BaselineOptions& options) {
    if (options.action == "compare") return compare(options);
    write_baseline(options.directory, options.file, options.replace);
    fmt::print("baseline: {}\n", options.file);
    return exit_done;
}

}  // namespace

void add_baseline(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<BaselineOptions>();
    CLI::App& command = *app.add_subcommand(
        "baseline", "store the results of a directory as a baseline, or compare them with one");
    command.add_option("action", options->action, "write or compare")
        ->required()
        ->check(CLI::IsMember({"write", "compare"}))
        ->type_name("");
    add_directory(command, options->directory, "directory of a suite or a run");
    command.add_option("--file", options->file, "the baseline, a JSON file")->required()->type_name("FILE");
    command.add_flag("--replace", options->replace, "with write: replace an existing baseline");
    add_json(command, options->json, "with compare: print JSON, for scripts");
    command.callback([options, &exit_code] { exit_code = baseline(*options); });
}

}  // namespace wetdeck
