// SPDX-License-Identifier: BSD-3-Clause
#include "validation/jobs/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "solver/core/errors.hpp"
#include "validation/run/assemble.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_directory.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

std::string identity_of(const SuiteRow& row) {
    const Scene scene = read_scene(find_scene(row.scene), row.variant, row.overrides);
    RunOptions options;
    options.particle_spacing = row.particle_spacing;
    options.until = row.until;
    return identity_of(scene, options);
}

/// The row of a scene that was read with overrides.
SuiteRow varied_row(const std::string& name, const Scene& varied, double particle_spacing,
                    const fs::path& directory) {
    return {name,
            varied.variant,
            particle_spacing,
            estimate_cost(varied, particle_spacing).core_seconds,
            varied.overrides,
            directory};
}

/// Two rows for each input that the scene varies.
void add_sensitivity_rows(std::vector<SuiteRow>& rows, const PlanOptions& options, const std::string& name,
                          const Scene& scene) {
    const Tier& tier = scene.tiers.at(options.tier);
    const auto spacings = tier.find(scene.variant);
    if (spacings == tier.end() || spacings->second.empty()) return;
    const double dx = spacings->second.front();
    for (const SensitivitySpec& spec : scene.analysis.sensitivities) {
        for (const bool high : {false, true}) {
            const std::string assignment = fmt::format("{}={}", spec.key, high ? spec.high : spec.low);
            std::vector<std::string> overrides = {assignment};
            const std::vector<std::string>& with = high ? spec.high_with : spec.low_with;
            overrides.insert(overrides.end(), with.begin(), with.end());
            rows.push_back(varied_row(name, read_scene(find_scene(name), scene.variant, overrides), dx,
                                      sensitivity_path(options.directory, scene.name(), assignment)));
        }
    }
}

/// Two rows for each variant whose sound speed the scene studies, at its coarsest spacing of the tier.
void add_sound_speed_rows(std::vector<SuiteRow>& rows, const PlanOptions& options, const std::string& name,
                          const Scene& scene) {
    for (const std::string& variant : scene.analysis.sound_speed_variants) {
        const Tier& tier = scene.tiers.at(options.tier);
        const auto spacings = tier.find(variant);
        if (spacings == tier.end() || spacings->second.empty()) continue;
        const double dx = spacings->second.front(),
                     own = read_scene(find_scene(name), variant).analysis.sound_speed;
        for (const double share : sound_speed_shares) {
            const std::string assignment = fmt::format("{}={}", sound_speed_key, share * own);
            std::vector<std::string> overrides = {assignment};
            const auto& larger = scene.analysis.twice_sound_speed_with;
            if (share > 1)  // the echo is back sooner
                overrides.insert(overrides.end(), larger.begin(), larger.end());
            else
                overrides.emplace_back("accepted_doubts.sound_speed=its effect is studied");
            const Scene varied = read_scene(find_scene(name), variant, overrides);
            check_row(varied, options.tier, dx);
            rows.push_back(
                varied_row(name, varied, dx,
                           options.directory / sound_speed_folder / scene.name() / variant / assignment));
        }
    }
}

void add_scene_rows(std::vector<SuiteRow>& rows, const PlanOptions& options, const std::string& name) {
    const fs::path path = find_scene(name);
    const Scene scene = read_scene(path);
    const auto tier = scene.tiers.find(options.tier);
    if (tier == scene.tiers.end()) {
        throw InputError(
            fmt::format("{}: no tier '{}', expected quick, standard or paper", path.string(), options.tier));
    }
    for (const auto& [variant, spacings] : tier->second) {
        const Scene varied = read_scene(path, variant);
        for (const double dx : spacings) {
            check_row(varied, options.tier, dx);
            rows.push_back({name,
                            variant,
                            dx,
                            estimate_cost(varied, dx).core_seconds,
                            {},
                            run_path(options.directory, scene.name(), variant, dx),
                            {},
                            varied.analysis.expected_unstable});
        }
    }
    add_sensitivity_rows(rows, options, name, scene);
    add_sound_speed_rows(rows, options, name, scene);
}

}  // namespace

std::vector<SuiteRow> suite_rows(const PlanOptions& options) {
    std::vector<SuiteRow> rows;
    for (const std::string& name : options.scenes.empty() ? scene_names() : options.scenes)
        add_scene_rows(rows, options, name);
    if (rows.empty())
        throw InputError(fmt::format(
            "tier '{}' of {} holds no run, expected spacings of a variant in the table [tiers]", options.tier,
            options.scenes.empty() ? "the shipped scenes"
                                   : fmt::format("{}", fmt::join(options.scenes, ", "))));
    std::stable_sort(rows.begin(), rows.end(), [](const SuiteRow& a, const SuiteRow& b) {
        return a.estimated_core_seconds > b.estimated_core_seconds;
    });
    return rows;
}

std::string row_name(const SuiteRow& row) {
    const std::string name = fmt::format("{} {} dx {}", row.scene, row.variant, row.particle_spacing);
    if (row.overrides.empty()) return name;
    return name + " " +
           (row.overrides.size() == 1 ? row.overrides.front() : row.directory.filename().string());
}

bool finished(const SuiteRow& row) {
    return holds_finished_run(row.directory) && identity_in(row.directory) == identity_of(row);
}

bool interrupted(const SuiteRow& row) {
    if (holds_finished_run(row.directory) || identity_in(row.directory) != identity_of(row)) return false;
    try {
        return newest_checkpoint(row.directory).has_value();
    } catch (const DataError&) {  // all are damaged
        return false;
    }
}

double estimated_core_seconds(const std::vector<SuiteRow>& rows) {
    double sum = 0;
    for (const SuiteRow& row : rows) sum += row.estimated_core_seconds;
    return sum;
}

fs::path sensitivity_path(const fs::path& directory, const std::string& scene,
                          const std::string& assignment) {
    return directory / "sensitivity" / scene / assignment;
}

fs::path run_path(const fs::path& directory, const std::string& scene, const std::string& variant,
                  double particle_spacing) {
    return directory / "runs" / scene / variant / fmt::format("dx{}", particle_spacing);
}

}  // namespace wetdeck
