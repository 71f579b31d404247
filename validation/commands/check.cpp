// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck check`: whether a file of the user is sound, without running anything.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/sketch.hpp"
#include "validation/metrics/reference_check.hpp"
#include "validation/metrics/reference_use.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/scene/plausibility.hpp"
#include "validation/scene/scene.hpp"
#include "validation/sections/section_address.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct CheckOptions {
    std::string file;
    std::string sketch;  ///< where to draw the scene, or empty
    bool strict = false, json = false;
};

/// What was found in a file that is sound.
struct Finding {
    std::string sentence;  ///< what the file is
    std::vector<std::string> notes, doubts;
    json details;
};

/// Reads the scene in every variant, and checks every spacing of its tiers.
Finding check_scene(const std::string& file) {
    const Scene scene = read_scene(file);
    Finding found;
    std::set<std::string> missing;
    ReferenceShelf shelf(reference_directory() / scene.name(), scene.analysis.folder);
    std::vector<std::string> variants;
    std::vector<AnalysisSpec> analyses;
    for (const VariantInfo& variant : scene.variants) {
        variants.push_back(variant.name);
        const Scene varied = read_scene(file, variant.name);
        missing.merge(check_references(varied.analysis, shelf));
        analyses.push_back(varied.analysis);
        const auto add_once = [](std::vector<std::string>& all, const std::string& text) {
            if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
        };
        for (const std::string& doubt : doubtful(varied)) add_once(found.doubts, doubt);
        for (const std::string& note : varied.notes) add_once(found.notes, note);
        for (const std::string& remark : remarks(varied)) add_once(found.notes, remark);
        for (const auto& [tier, spacings_of] : varied.tiers) {
            const auto spacings = spacings_of.find(variant.name);
            if (spacings == spacings_of.end()) continue;
            for (const double dx : spacings->second) {
                check_row(varied, tier, dx);
                for (const std::string& doubt : doubts_at_spacing(varied, dx)) add_once(found.doubts, doubt);
            }
        }
    }
    for (const std::string& name : missing)
        found.notes.push_back(fmt::format(
            "no file {}.csv beside the scene or in reference_data/: its comparison will be left out", name));
    const std::set<std::string> unmentioned =
        unmentioned_references(analyses, reference_directory() / scene.name());
    for (const std::string& name : unmentioned)
        found.notes.push_back(fmt::format(
            "reference_data/{}/{}.csv is neither compared with nor listed in [[unused_references]]",
            scene.name(), name));
    found.sentence = fmt::format("scene '{}' with {} variant{}", scene.name(), variants.size(),
                                 variants.size() == 1 ? "" : "s");
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
    const std::vector<std::string> missing = missing_recommended_keys(reference);
    Finding found{fmt::format("{} reference, {} columns", name_of(reference.kind), columns),
                  {},
                  {},
                  {{"kind", name_of(reference.kind)}, {"columns", columns}, {"missing_keys", missing}}};
    if (!missing.empty())
        found.notes.push_back(
            fmt::format("recommended keys that its header lacks: {}", fmt::join(missing, ", ")));
    return found;
}

/// Why the corners are no outline, of a whole section or of half of a mirrored one; empty if they are.
std::string outline_problem(const Outline& corners, bool half) {
    try {
        check_outline(half ? mirrored_section(corners) : corners);
        return {};
    } catch (const InputError& error) {
        return error.what();
    }
}

/// A file of corners is sound if they are an outline, or the half of one.
Finding check_corners(const std::string& file) {
    const Outline corners = read_outline(file);
    const std::string problem = outline_problem(corners, false);
    const bool half = outline_problem(corners, true).empty();
    if (!problem.empty() && !half) throw InputError(fmt::format("{}: {}", file, problem));
    Box box{corners.front(), corners.front()};
    for (const Vec2& corner : corners) {
        box.low = box.low.cwiseMin(corner);
        box.high = box.high.cwiseMax(corner);
    }
    return {fmt::format("outline of {} corners, x from {:g} to {:g} m, y from {:g} to {:g} m, {}",
                        corners.size(), box.low.x(), box.high.x(), box.low.y(), box.high.y(),
                        half ? "fit for 'mirrored = true'" : "not fit for 'mirrored = true'"),
            {},
            {},
            {{"kind", "outline"}, {"corners", corners.size()}, {"half", half}}};
}

/// A GHS file, a drawing or a table of offsets, all of it; or one section where one is named.
Finding check_sections(const SectionAddress& address) {
    if (address.names_station()) {
        const ChosenSection chosen = read_section_at(address);
        check_outline(chosen.half ? mirrored_section(chosen.corners) : chosen.corners);
        return {fmt::format("{}, outline of {} corners{}", chosen.title, chosen.corners.size(),
                            chosen.half ? ", fit for 'mirrored = true'" : ""),
                chosen.notes,
                {},
                {{"kind", "section"}, {"corners", chosen.corners.size()}, {"half", chosen.half}}};
    }
    const SectionFile file = read_sections(address.file, address.options());
    Finding found{fmt::format("{} of {} {}{}, lengths in {}", file.format, file.stations.size(), file.key,
                              file.stations.size() == 1 ? "" : "s", file.unit),
                  file.notes,
                  {},
                  {{"kind", file.format}, {"stations", file.stations.size()}, {"unit", file.unit}}};
    for (const Station& station : file.stations)
        if (!station.problem.empty())
            found.notes.push_back(fmt::format("{}: {}", station.title(), station.problem));
    found.notes.push_back("list its sections: wetdeck sections " + address.text());
    return found;
}

bool is_table(const std::string& file) {
    std::string extension = fs::path(file).extension();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension == ".csv" || extension == ".tsv" || extension == ".txt" || extension == ".dat";
}

Finding check_file(const std::string& file) {
    if (const auto address = section_address(file)) return check_sections(*address);
    if (!is_table(file)) return check_scene(file);
    if (!fs::is_regular_file(file) || looks_like_reference(read_whole_file(file))) return check_curve(file);
    try {
        return check_corners(file);
    } catch (const InputError& error) {  // the file may have been meant as the other kind of .csv
        throw InputError(fmt::format("{} (a reference curve begins with '# kind: ...')", error.what()));
    }
}

void print_json(const std::string& file, bool valid, json details) {
    details["file"] = file;
    details["valid"] = valid;
    fmt::print("{}\n", details.dump(1));
}

/// Never replaces a file that is there.
void draw(const CheckOptions& options) {
    if (is_table(options.file))
        throw InputError(fmt::format("--sketch draws a scene, and {} is none", options.file));
    if (fs::exists(options.sketch))
        throw InputError(fmt::format("--sketch {}: the file exists, expected a new name", options.sketch));
    sketch(read_scene(options.file)).write(options.sketch);
}

int check(const CheckOptions& options) {
    Finding found;
    try {
        found = check_file(options.file);
    } catch (const InputError& error) {
        if (options.json) print_json(options.file, false, {{"message", error.what()}});
        throw;
    }
    if (!options.sketch.empty()) draw(options);
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
        "check",
        "check a scene file (.toml), a reference curve or an outline (.csv), or hull sections (.gf, .dxf, "
        "offsets) without running it");
    command.add_option("file", options->file, "path of the file")->required()->type_name("");
    command
        .add_option("--sketch", options->sketch,
                    "draw the set-up to this file, .png or .svg: tank, fluids, bodies, given motions, probes")
        ->type_name("FILE");
    command.add_flag("--strict", options->strict,
                     "end with exit code 2 if a value is doubtful (lines that begin with \"doubt:\")");
    add_json(command, options->json);
    command.callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace wetdeck
