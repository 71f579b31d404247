// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck check`: whether a file of the user is sound, without running anything.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/analytic/curves.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/metrics/reference_use.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/scene/plausibility.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct CheckOptions {
    std::string file;
    bool strict = false, json = false;
};

/// What was found in a file that is sound.
struct Finding {
    std::string sentence;  ///< what the file is
    std::vector<std::string> notes, doubts;
    json details;
};

/// Reads the curves that a scene is compared with, and returns the names of those that do not exist. Throws
/// DataError where one is not sound or lacks a column.
std::set<std::string> missing_references(const Scene& scene) {
    ReferenceShelf shelf(reference_directory() / scene.name(), scene.analysis.folder);
    std::set<std::string> missing;
    for (const ComparisonSpec& c : scene.analysis.comparisons) {
        if (is_analytic(c.reference)) continue;  // checked when the scene was read
        if (const Reference* reference = shelf.find(c.reference)) {
            column_curve(*reference, c.x_column, c.y_column);
        } else {
            missing.insert(c.reference);
        }
    }
    return missing;
}

/// Reads the scene in every variant, and checks every spacing of its tiers.
Finding check_scene(const std::string& file) {
    const Scene scene = read_scene(file);
    Finding found;
    const std::set<std::string> missing = missing_references(scene);
    for (const std::string& name : missing)
        found.notes.push_back(fmt::format(
            "no file {}.csv beside the scene or in reference_data/: its comparison will be left out", name));
    std::vector<std::string> variants;
    std::vector<AnalysisSpec> analyses;
    for (const VariantInfo& variant : scene.variants) {
        variants.push_back(variant.name);
        const Scene varied = read_scene(file, variant.name);
        analyses.push_back(varied.analysis);
        const auto add_once = [](std::vector<std::string>& all, const std::string& text) {
            if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
        };
        for (const std::string& doubt : doubtful(varied)) add_once(found.doubts, doubt);
        for (const std::string& note : varied.notes) add_once(found.notes, note);
        for (const auto& [tier, spacings_of] : varied.tiers) {
            const auto spacings = spacings_of.find(variant.name);
            if (spacings == spacings_of.end()) continue;
            for (const double dx : spacings->second) {
                check_row(varied, tier, dx);
                if (const auto doubt = doubtful_step(varied, dx)) add_once(found.doubts, *doubt);
            }
        }
    }
    const std::set<std::string> unmentioned =
        unmentioned_references(analyses, reference_directory() / scene.name());
    for (const std::string& name : unmentioned)
        found.notes.push_back(fmt::format(
            "reference_data/{}/{}.csv is neither compared with nor listed in [[unused_references]]",
            scene.name(), name));
    found.sentence = fmt::format("scene '{}' with {} variants", scene.name(), variants.size());
    found.details = {{"scene", scene.name()},
                     {"variants", variants},
                     {"missing_references", missing},
                     {"unmentioned_references", unmentioned},
                     {"doubts", found.doubts}};
    return found;
}

Finding check_curve(const std::string& file) {
    const Reference reference = load_reference(file);
    const std::size_t columns = reference.columns.size();
    return {fmt::format("{} reference, {} columns", name_of(reference.kind), columns),
            {},
            {},
            {{"kind", name_of(reference.kind)}, {"columns", columns}}};
}

Finding check_outline(const std::string& file) {
    try {
        const std::size_t corners = read_outline(file).size();
        return {fmt::format("outline of {} corners", corners),
                {},
                {},
                {{"kind", "outline"}, {"corners", corners}}};
    } catch (const InputError& error) {  // the file may have been meant as the other kind of .csv
        throw InputError(fmt::format("{} (a reference curve begins with '# kind: ...')", error.what()));
    }
}

/// Whether the comments at the head of a file have the key "kind", as those of a reference curve do.
bool names_kind(const std::string& file) {
    std::ifstream in(file);
    std::string line;
    while (std::getline(in, line) && line.find('#') != std::string::npos)
        if (line.find("kind:") != std::string::npos) return true;
    return false;
}

Finding check_file(const std::string& file) {
    if (fs::path(file).extension() != ".csv") return check_scene(file);
    return !fs::is_regular_file(file) || names_kind(file) ? check_curve(file) : check_outline(file);
}

void print_json(const std::string& file, bool valid, json details) {
    details["file"] = file;
    details["valid"] = valid;
    fmt::print("{}\n", details.dump(1));
}

int check(const CheckOptions& options) {
    Finding found;
    try {
        found = check_file(options.file);
    } catch (const InputError& error) {
        if (options.json) print_json(options.file, false, {{"message", error.what()}});
        throw;
    }
    if (options.json) {
        print_json(options.file, true, found.details);
    } else {
        fmt::print("{}: {}, no error found\n", options.file, found.sentence);
        for (const std::string& note : found.notes) fmt::print("{}\n", note);
    }
    std::fflush(stdout);
    for (const std::string& doubt : found.doubts) fmt::print(stderr, "doubt: {}\n", doubt);
    return options.strict && !found.doubts.empty() ? exit_usage : exit_done;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<CheckOptions>();
    CLI::App& command = *app.add_subcommand(
        "check", "check a scene file (.toml), a reference curve or an outline (.csv) without running it");
    command.add_option("file", options->file, "path of the file")->required()->type_name("");
    command.add_flag("--strict", options->strict,
                     "end with exit code 2 if a value is doubtful (lines that begin with \"doubt:\")");
    add_json(command, options->json);
    command.callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace wetdeck
