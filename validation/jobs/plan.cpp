// SPDX-License-Identifier: BSD-3-Clause
#include "validation/jobs/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "solver/core/errors.hpp"
#include "validation/run/assemble.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/shown_frames.hpp"
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

/// One key of a variant with another value, and the keys that must change with it.
struct VariedKey {
    std::string key;
    double value = 0;
    std::vector<std::string> with = {};  ///< KEY=VALUE

    std::string assignment() const { return fmt::format("{}={}", key, value); }
    std::vector<std::string> overrides() const {
        std::vector<std::string> all = {assignment()};
        all.insert(all.end(), with.begin(), with.end());
        return all;
    }
};

/// @param scene  of the variant, as varied or at the same cost
SuiteRow row_of(const std::string& name, const Scene& scene, double particle_spacing,
                const fs::path& directory) {
    const CostEstimate cost = estimate_cost(scene, particle_spacing);
    SuiteRow row{name, scene.variant, particle_spacing, cost.core_seconds, {}, directory};
    row.fluid_particles = cost.fluid_particles;
    row.frames = scene.frame_times.size();
    row.shown_frames = shown_frames(scene).size();
    return row;
}

/// @param folder  of the study; the run lies in it under the assignment
SuiteRow varied_row(const std::string& name, const Scene& scene, const VariedKey& varied,
                    double particle_spacing, const fs::path& folder) {
    SuiteRow row = row_of(name, scene, particle_spacing, folder / varied.assignment());
    row.overrides = varied.overrides();
    return row;
}

/// Of the variant in the tier of the plan; none where it does not run there.
std::optional<double> coarsest_spacing(const PlanOptions& options, const Scene& scene,
                                       const std::string& variant) {
    const Tier& tier = scene.tiers.at(options.tier);
    const auto spacings = tier.find(variant);
    if (spacings == tier.end() || spacings->second.empty()) return std::nullopt;
    return *std::max_element(spacings->second.begin(), spacings->second.end());
}

/// Two rows for each input that the scene varies.
void add_sensitivity_rows(std::vector<SuiteRow>& rows, const PlanOptions& options, const std::string& name,
                          const Scene& scene) {
    const auto dx = coarsest_spacing(options, scene, scene.variant);
    if (!dx) return;
    const fs::path folder = options.directory / sensitivity_folder / scene.name();
    for (const SensitivitySpec& spec : scene.analysis.sensitivities) {
        for (const VariedKey& varied :
             {VariedKey{spec.key, spec.low, spec.low_with}, {spec.key, spec.high, spec.high_with}}) {
            const Scene as_varied = read_scene(find_scene(name), scene.variant, varied.overrides());
            rows.push_back(varied_row(name, as_varied, varied, *dx, folder));
        }
    }
}

/// Two rows for each variant whose sound speed the scene studies, at its coarsest spacing of the tier.
void add_sound_speed_rows(std::vector<SuiteRow>& rows, const PlanOptions& options, const std::string& name,
                          const Scene& scene) {
    for (const std::string& variant : scene.analysis.sound_speed_variants) {
        const auto dx = coarsest_spacing(options, scene, variant);
        if (!dx) continue;
        const double own = read_scene(find_scene(name), variant).analysis.sound_speed;
        for (const double share : sound_speed_shares) {
            VariedKey varied{sound_speed_key, share * own};
            if (share > 1)  // the echo is back sooner
                varied.with = scene.analysis.twice_sound_speed_with;
            else
                varied.with = {"accepted_doubts.sound_speed=its effect is studied"};
            const Scene as_varied = read_scene(find_scene(name), variant, varied.overrides());
            check_row(as_varied, options.tier, *dx);
            rows.push_back(varied_row(name, as_varied, varied, *dx,
                                      options.directory / sound_speed_folder / scene.name() / variant));
        }
    }
}

/// The replicates of each variant that the scene names, at its coarsest spacing of the tier.
void add_replicate_rows(std::vector<SuiteRow>& rows, const PlanOptions& options, const std::string& name,
                        const Scene& scene) {
    for (const std::string& variant : scene.analysis.replicated_variants) {
        const auto dx = coarsest_spacing(options, scene, variant);
        if (!dx) continue;
        const fs::path folder = options.directory / replicates_folder / scene.name() / variant;
        const Scene lattice = read_scene(find_scene(name), variant);
        for (int seed = 1; seed <= options.replicates.value_or(scene.analysis.replicates); ++seed)
            rows.push_back(varied_row(name, lattice, {arrangement_key, double(seed)}, *dx, folder));
    }
}

/// Whether the report shows pictures of the variant beside others, at a spacing that they have in common.
bool beside_others(const Scene& scene, const std::string& variant) {
    const std::vector<SideBySide>& entries = scene.analysis.side_by_side;
    return std::any_of(entries.begin(), entries.end(), [&variant](const SideBySide& entry) {
        return entry.time &&
               std::find(entry.variants.begin(), entry.variants.end(), variant) != entry.variants.end();
    });
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
            SuiteRow row = row_of(name, varied, dx, run_path(options.directory, scene.name(), variant, dx));
            row.expected_unstable = varied.analysis.expected_unstable;
            row.pictured = dx == spacings.back() || beside_others(scene, variant);
            rows.push_back(std::move(row));
        }
    }
    add_sensitivity_rows(rows, options, name, scene);
    add_sound_speed_rows(rows, options, name, scene);
    add_replicate_rows(rows, options, name, scene);
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
    if (!row.label.empty()) return name + " " + row.label;
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

Fields fields_of(const SuiteRow& row, const RowOptions& options) {
    if (!row.overrides.empty()) return Fields::none;
    return options.fields == Fields::key && !row.pictured ? Fields::none : options.fields;
}

double estimated_bytes(const SuiteRow& row, const RowOptions& options) {
    // measured over the quick tier; boundary particles are in the field files, too
    constexpr double run_file = 6e5, particle_in_frame = 33, particle_in_checkpoint = 205;
    const Fields fields = fields_of(row, options);
    const double frames = fields == Fields::none  ? 0
                          : fields == Fields::key ? static_cast<double>(row.shown_frames)
                                                  : static_cast<double>(row.frames);
    const double checkpoint = fields == Fields::all ? particle_in_checkpoint : 0;
    return run_file + row.fluid_particles * (frames * particle_in_frame + checkpoint);
}

double estimated_core_seconds(const std::vector<SuiteRow>& rows) {
    double sum = 0;
    for (const SuiteRow& row : rows) sum += row.estimated_core_seconds;
    return sum;
}

fs::path run_path(const fs::path& directory, const std::string& scene, const std::string& variant,
                  double particle_spacing) {
    return directory / "runs" / scene / variant / fmt::format("dx{}", particle_spacing);
}

}  // namespace wetdeck
