// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/one_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "validation/scene/identity.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

constexpr std::size_t most_differences = 5;

/// The runs that speak for a scene and for each of its variants: those that were started last.
struct Latest {
    std::map<std::string, const RunRecord*> of_scene;
    std::map<std::pair<std::string, std::string>, const RunRecord*> of_variant;
};

Latest latest_of(const std::vector<RunSummary>& runs) {
    Latest latest;
    const auto keep_later = [](const RunRecord*& found, const RunRecord& record) {
        if (!found || provenance_entry(record, "start_time") > provenance_entry(*found, "start_time"))
            found = &record;
    };
    for (const RunSummary& run : runs) {
        keep_later(latest.of_scene[run.record.scene], run.record);
        keep_later(latest.of_variant[{run.record.scene, run.record.variant}], run.record);
    }
    return latest;
}

std::vector<std::string> overrides_of(const RunRecord& record) {
    std::vector<std::string> overrides;
    std::string rest = provenance_entry(record, "overrides");
    for (std::size_t end; !rest.empty(); rest.erase(0, end)) {
        end = std::min(rest.find("; "), rest.size());
        overrides.push_back(rest.substr(0, end));
        end = std::min(end + 2, rest.size());
    }
    return overrides;
}

/// Set-up of a run as the text of a scene gives it; nothing if the text has no such variant.
std::optional<json> setup_from(const RunRecord& text, const RunRecord& run) {
    const auto is_of_run = [&run](const VariantInfo& variant) { return variant.name == run.variant; };
    const auto variants = parse_scene(text.scene_text, text.scene_path).variants;
    if (std::none_of(variants.begin(), variants.end(), is_of_run)) return std::nullopt;
    return setup_json(parse_scene(text.scene_text, text.scene_path, run.variant, overrides_of(run)));
}

std::string revision_of(const RunRecord& record) {
    const auto found = record.parameters.find("scheme_revision");
    return found == record.parameters.end() ? "unknown" : fmt::format("{:g}", found->second);
}

/// The path of a change in a set-up, in the words of a scene file: "/parameters/water.density".
std::string key_of(std::string path) {
    for (const std::string start : {"/parameters/", "/"}) {
        if (path.rfind(start, 0) != 0) continue;
        path.erase(0, start.size());
        break;
    }
    std::replace(path.begin(), path.end(), '/', '.');
    return path;
}

std::vector<std::string> differences(const json& own, const json& latest) {
    std::vector<std::string> words;
    std::size_t more = 0;
    for (const json& change : json::diff(latest, own)) {
        const std::string path = change.at("path");
        if (words.size() == most_differences) {
            ++more;
            continue;
        }
        const json::json_pointer at(path);
        const bool in_own = change.at("op") != "remove";
        const bool in_latest = change.at("op") != "add";
        words.push_back(fmt::format("{} is {}, in the latest run {}", key_of(path),
                                    in_own ? own.at(at).dump() : "absent",
                                    in_latest ? latest.at(at).dump() : "absent"));
    }
    if (more > 0) words.push_back(fmt::format("and {} more", more));
    return words;
}

/// What makes the run one of another set-up; empty if nothing does.
std::vector<std::string> other_than_latest(const RunRecord& run, const Latest& latest) {
    const RunRecord& same_variant = *latest.of_variant.at({run.scene, run.variant});
    if (provenance_entry(run, "setup_identity") != provenance_entry(same_variant, "setup_identity")) {
        std::vector<std::string> words;
        if (revision_of(run) != revision_of(same_variant))
            words.push_back(fmt::format("the revision of the numerical scheme is {}, in the latest run {}",
                                        revision_of(run), revision_of(same_variant)));
        const auto own = setup_from(run, run), other = setup_from(same_variant, same_variant);
        for (std::string& word : differences(own.value_or(json()), other.value_or(json())))
            words.push_back(std::move(word));
        if (words.empty())
            words.emplace_back("a file that the scene names, or the version of the program, differs");
        return words;
    }
    const RunRecord& of_scene = *latest.of_scene.at(run.scene);
    if (of_scene.scene_text == run.scene_text) return {};
    const auto own = setup_from(run, run), as_latest = setup_from(of_scene, run);
    if (!as_latest) return {"the scene has no such variant any more"};
    return differences(own.value_or(json()), *as_latest);
}

LeftOutRun left_out(const RunSummary& run, std::vector<std::string> words) {
    return {run.directory, run.record.scene, run.record.variant, run.record.particle_spacing,
            std::move(words)};
}

}  // namespace

std::vector<LeftOutRun> leave_out_other_setups(std::vector<RunSummary>& runs,
                                               std::vector<SensitivityRun>& varied) {
    const Latest latest = latest_of(runs);
    std::map<std::pair<std::string, std::string>, std::string> shown;  // variants with their set-up
    std::vector<LeftOutRun> out;
    for (RunSummary& run : runs) {
        const RunRecord& r = run.record;
        std::vector<std::string> words = other_than_latest(r, latest);
        shown.insert({{r.scene, r.variant}, ""});
        if (words.empty())
            shown[{r.scene, r.variant}] = provenance_entry(r, "setup_identity");
        else
            out.push_back(left_out(run, std::move(words)));
    }
    const auto is_left_out = [&out](const RunSummary& run) {
        return std::any_of(out.begin(), out.end(),
                           [&run](const LeftOutRun& other) { return other.directory == run.directory; });
    };
    std::erase_if(runs, is_left_out);
    std::erase_if(varied, [&](const SensitivityRun& one) {
        const RunRecord& r = one.run.record;
        const auto found = shown.find({r.scene, r.variant});
        if (found == shown.end() || provenance_entry(r, "base_setup_identity") == found->second) return false;
        out.push_back(
            left_out(one.run, {"it varies one input of another set-up than that of the latest run"}));
        return true;
    });
    return out;
}

}  // namespace wetdeck
