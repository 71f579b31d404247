// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/scene.hpp"
#include "validation/scene/expressions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "solver/core/errors.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "validation/scene/expected_motion.hpp"
#include "validation/scene/motion_section.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/scene/resolution_section.hpp"
#include "validation/scene/schemes.hpp"
#include "validation/scene/sections.hpp"
#include "validation/scene/symmetry_section.hpp"
#include "validation/scene/toml_reader.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_scene_file = 1'000'000;  // [bytes]

std::string scene_text(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        throw InputError(fmt::format("{}: no such scene file", path.string()));
    if (fs::file_size(path) > largest_scene_file) {
        throw InputError(
            fmt::format("{}: larger than {} bytes, not a scene file", path.string(), largest_scene_file));
    }
    return read_whole_file(path);
}

/// @param taken  boxes that are filled already
std::vector<Box> read_boxes(const TomlTable& table, const Box& tank, const std::vector<Box>& taken) {
    std::vector<Box> boxes;
    for (const std::vector<double>& row : table.number_rows("boxes", 4)) {
        const Box box{{row[0], row[1]}, {row[2], row[3]}};
        const bool proper = (box.high - box.low).minCoeff() > 0;
        const bool inside =
            (box.low - tank.low).minCoeff() > -1e-9 && (tank.high - box.high).minCoeff() > -1e-9;
        if (!proper) table.fail("boxes", "expected x_low, y_low, x_high, y_high with low below high");
        if (!inside) table.fail("boxes", "a box reaches outside the tank");
        const auto overlaps = [&box](const Box& other) {
            return (box.high.cwiseMin(other.high) - box.low.cwiseMax(other.low)).minCoeff() > 1e-9;
        };
        if (std::any_of(boxes.begin(), boxes.end(), overlaps) ||
            std::any_of(taken.begin(), taken.end(), overlaps)) {
            table.fail("boxes", "two boxes overlap");
        }
        boxes.push_back(box);
    }
    return boxes;
}

/// The pressure after Greco is that of one column: throws where the water is another.
void check_column(const TomlTable& initial, const Scene& scene) {
    constexpr double tolerance = 1e-9;
    const double face = scene.initial.released_face;
    double left = scene.tank.high.x(), right = scene.tank.low.x();
    const auto wet = [&](double x, double y) {
        return std::any_of(scene.water_boxes.begin(), scene.water_boxes.end(), [&](const Box& box) {
            return box.low.x() <= x && x <= box.high.x() && box.low.y() <= y && y <= box.high.y();
        });
    };
    for (const Box& box : scene.water_boxes) {
        const double below = box.low.y() - tolerance;
        const bool stands =
            below <= 0 || (wet(box.low.x() + tolerance, below) && wet(box.high.x() - tolerance, below));
        left = std::min(left, box.low.x());
        right = std::max(right, box.high.x());
        const double top = water_top(scene.water_boxes, box.low + Vec2::Constant(tolerance));
        if (!stands || std::abs(top - scene.initial.surface) > tolerance)
            initial.fail("pressure",
                         fmt::format("'greco' is that of one column from the floor to the surface at {} m; a "
                                     "box of water reaches from y = {} to {} m",
                                     scene.initial.surface, box.low.y(), top));
    }
    const auto ends_at_face = [&](const Box& box) {
        return std::min(std::abs(box.low.x() - face), std::abs(box.high.x() - face)) < tolerance;
    };
    const bool both_sides = face - left > tolerance && right - face > tolerance;
    const bool at_wall = face - scene.tank.low.x() < tolerance || scene.tank.high.x() - face < tolerance;
    if (both_sides || at_wall ||
        std::none_of(scene.water_boxes.begin(), scene.water_boxes.end(), ends_at_face))
        initial.fail("released_face",
                     fmt::format("is x = {} m, expected the free end of the column of water, whose "
                                 "boxes reach from x = {} to {} m in a tank from {} to {} m",
                                 face, left, right, scene.tank.low.x(), scene.tank.high.x()));
    const double held = face - left > tolerance ? left - scene.tank.low.x() : scene.tank.high.x() - right;
    if (held > tolerance)
        initial.fail("pressure",
                     fmt::format("'greco' is that of a column held by a wall of the tank; this one, "
                                 "from x = {} to {} m, is free at both ends",
                                 left, right));
}

double highest_top(const std::vector<Box>& boxes) {
    double top = 0;
    for (const Box& box : boxes) top = std::max(top, box.high.y());
    return top;
}

/// A whole number: a seed that was rounded would be another one.
void read_arrangement(const TomlTable& initial, Scene& scene) {
    constexpr double largest = 1e9;
    const double seed = initial.number_or("arrangement", 0);
    if (seed < 0 || seed > largest || seed != std::floor(seed))
        initial.fail("arrangement", "expected a whole number from 0 (the lattice) to 1e9");
    scene.arrangement = static_cast<std::uint64_t>(seed);
}

void read_initial(const TomlTable& root, Scene& scene) {
    const TomlTable table = root.table("initial");
    const std::optional<double> surface = table.optional_number("surface");
    scene.initial.surface = surface ? *surface : highest_top(scene.water_boxes);
    if (table.choice("pressure", {"hydrostatic", "greco"}) == "greco") {
        scene.initial.law = InitialPressure::Law::greco;
        scene.initial.released_face = table.number("released_face");
        check_column(table, scene);
    } else {
        table.has("released_face");
    }
    read_arrangement(table, scene);
    table.finish();
}

void read_run(const TomlTable& root, Scene& scene) {
    const TomlTable table = root.table("run");
    scene.end_time = table.positive("end_time");
    scene.sample_interval = table.positive("sample_interval");
    scene.force_filter = table.number_or("force_filter", 0);
    if (scene.force_filter < 0) table.fail("force_filter", "expected zero or a positive width [s]");
    if (table.has("frames")) scene.frame_times = scene.picture_times = table.numbers("frames");
    if (const auto interval = table.optional_number("frame_interval")) {
        if (!(*interval > 0)) table.fail("frame_interval", "expected a positive number");
        if (scene.end_time / *interval > 100'000)
            table.fail("frame_interval", "would write more than 100,000 frames");
        for (double t = 0; t < scene.end_time; t += *interval) scene.frame_times.push_back(t);
    }
    scene.frame_times.push_back(0);
    scene.frame_times.push_back(scene.end_time);
    std::sort(scene.frame_times.begin(), scene.frame_times.end());
    const auto close = [&](double a, double b) { return b - a < 1e-6 * scene.end_time; };
    scene.frame_times.erase(std::unique(scene.frame_times.begin(), scene.frame_times.end(), close),
                            scene.frame_times.end());
    table.finish();
}

void read_tiers(const TomlTable& root, Scene& scene) {
    const std::optional<TomlTable> tiers = root.optional_table("tiers");
    if (!tiers) return;
    for (const std::string& tier : tiers->keys()) {
        const TomlTable table = tiers->table(tier);
        for (const std::string& variant : table.keys()) {
            const bool known = std::any_of(scene.variants.begin(), scene.variants.end(),
                                           [&](const VariantInfo& v) { return v.name == variant; });
            if (!known) table.fail(variant, "is not a variant of this scene");
            std::vector<double> spacings = table.numbers(variant);
            for (double dx : spacings) {
                if (!(dx > 0)) table.fail(variant, "expected positive spacings");
            }
            std::sort(spacings.rbegin(), spacings.rend());
            scene.tiers[tier][variant] = spacings;
        }
    }
}

/// Keys that had another name in earlier releases. Those of bodies are renamed in each body's table.
/// @param may_replace  whether entries of the new name are older than those of the old name
void rename_old_keys(TomlDocument& document, bool may_replace, std::vector<std::string>& notes) {
    std::vector<std::pair<std::string, std::string>> renamed = {{"model.full_cover", "model.full_kernel_sum"},
                                                                {"model.tension", "model.negative_pressure"},
                                                                {"model.skin", "execution.skin"},
                                                                {"origins", "time_origins"}};
    for (const std::string& key : document.root().keys())
        if (key == "body" || key.starts_with("body_"))
            renamed.emplace_back(key + ".place", key + ".position");
    for (const auto& [old_key, new_key] : renamed)
        if (const auto note = document.rename(old_key, new_key, may_replace)) notes.push_back(*note);
}

/// The scheme that the overrides, the variant or the scene names, or an empty name.
std::string chosen_scheme(const TomlTable& root, const std::string& variant,
                          const std::vector<std::string>& overrides) {
    const std::string overriding = scheme_in(overrides);
    if (!overriding.empty()) return overriding;
    const TomlTable table = root.table("variants").table(variant);
    return table.has("scheme") ? table.text("scheme") : root.text_or("scheme", "");
}

Scene read_document(TomlDocument document, const std::optional<std::string>& wanted,
                    const std::vector<std::string>& overrides, const std::string& path) {
    Scene scene;
    std::vector<std::string> names;
    {
        const TomlTable root = document.root();
        const TomlTable variants = root.table("variants");
        names = variants.keys();
        for (const std::string& name : names) {
            const TomlTable variant = variants.table(name);
            scene.variants.push_back(
                {name, variant.text_or("description", ""), variant.text_or("scheme", "")});
        }
        scene.analysis.default_variant = root.choice("default_variant", names);
    }
    scene.variant = wanted.value_or(scene.analysis.default_variant);
    if (std::find(names.begin(), names.end(), scene.variant) == names.end()) {
        throw InputError(fmt::format("{}: no variant '{}', expected one of {}", path, scene.variant,
                                     fmt::join(names, ", ")));
    }
    rename_old_keys(document, false, scene.notes);
    const std::string scheme = chosen_scheme(document.root(), scene.variant, overrides);
    if (!scheme.empty()) document.overlay({"schemes", scheme}, TomlDocument::Overlay::of_existing_tables);
    document.overlay({"variants", scene.variant});
    rename_old_keys(document, true, scene.notes);
    for (const std::string& assignment : overrides) document.set(assignment);
    rename_old_keys(document, true, scene.notes);

    const TomlTable root = document.root();
    if (root.number("schema") != 1) root.fail("schema", "expected 1");
    scene.analysis.scene = root.text("name");
    scene.analysis.title = root.text("title");
    scene.analysis.purpose = root.text("purpose");
    scene.analysis.source = root.text("source");
    root.has("default_variant");
    root.has("variants");
    root.has("description");  // of the variant that was laid over the root
    root.has("scheme");
    root.has("schemes");
    scene.source_scheme = root.choice("source_scheme", scheme_names(), "");
    scene.analysis.expected_unstable = root.choice("expect", {"stable", "unstable"}, "stable") == "unstable";

    const TomlTable tank = root.table("tank");
    const Outline tank_outline = read_tank(tank, scene);
    if (const std::optional<TomlTable> accepted = root.optional_table("accepted_doubts")) {
        scene.accepted = {accepted->text_or("sound_speed", ""), accepted->text_or("echo", "")};
        accepted->finish();
    }

    read_model(root, scene);
    const TomlTable water = root.table("water");
    scene.water_boxes = read_boxes(water, scene.tank, {});
    for (const std::vector<double>& row :
         water.has("velocities") ? water.number_rows("velocities", 2) : std::vector<std::vector<double>>{})
        scene.water_velocities.emplace_back(row[0], row[1]);
    if (!scene.water_velocities.empty() && scene.water_velocities.size() != scene.water_boxes.size())
        water.fail("velocities", fmt::format("has {} rows, expected one [x, y] for each of the {} boxes",
                                             scene.water_velocities.size(), scene.water_boxes.size()));
    for (const char* key : {"density", "sound_speed", "exponent", "viscosity"}) water.has(key);
    water.finish();
    if (const std::optional<TomlTable> air = root.optional_table("air")) {
        scene.air_boxes = read_boxes(*air, scene.tank, scene.water_boxes);
        for (const char* key : {"density", "sound_speed", "exponent", "viscosity", "law"}) air->has(key);
        air->finish();
    }
    read_run(root, scene);
    read_tank_motion(tank, scene);
    read_bodies(root, scene);
    if (!tank_outline.empty()) add_tank_walls(tank, tank_outline, scene);
    for (const BodySpec& spec : scene.bodies) {
        if (spec.solid || !root.table(spec.name).has("motion")) continue;
        if (const auto collision = collision_of_given_motion(scene, spec))
            root.table(spec.name).fail("motion", *collision);
    }
    read_initial(root, scene);
    read_tiers(root, scene);
    read_probes(root, scene);
    read_symmetry(root, scene);
    read_resolution(root, scene);
    read_analysis(root, scene);
    root.has("parameters");
    scene.parameters = root.expressions().parameters();
    scene.unused_parameters = root.expressions().unused();
    root.finish();
    scene.resolved = document.resolved();
    scene.probe_text = document.array_text("probes", {"note"});
    return scene;
}

}  // namespace

Outline BodySpec::local_outline() const {
    Outline local;
    for (const Vec2& corner : outline) local.push_back(body.local(corner));
    return local;
}

namespace {

bool has(const Scene& scene, FieldSeries::Needs needs) {
    if (needs == FieldSeries::Needs::air) return scene.air;
    return !scene.bodies.empty() && (needs == FieldSeries::Needs::bodies || scene.resolution);
}

}  // namespace

std::vector<FieldSeries> field_series(const Scene& scene) {
    std::vector<FieldSeries> all;
    for (const FieldSeries& each : all_field_series())
        if (has(scene, each.needs)) all.push_back(each);
    return all;
}

std::vector<Outline> outlines_carried_by(const Scene& scene, const BodySpec& body) {
    std::vector<Outline> outlines = {body.outline};
    const auto number = static_cast<std::size_t>(&body - scene.bodies.data());
    for (const BodySpec& other : scene.bodies)
        if (other.body.joined_to == number) outlines.push_back(other.outline);
    return outlines;
}

std::vector<Outline> local_outlines(const Scene& scene) {
    std::vector<Outline> outlines;
    for (const BodySpec& spec : scene.bodies) outlines.push_back(spec.local_outline());
    return outlines;
}

Scene parse_scene(const std::string& text, const std::string& path, const std::optional<std::string>& variant,
                  const std::vector<std::string>& overrides) {
    const std::string complete = with_schemes(text, path, overrides);
    Scene scene = read_document(TomlDocument(complete, path), variant, overrides, path);
    scene.text = complete;
    scene.path = path;
    scene.analysis.folder = fs::path(path).parent_path();
    scene.overrides = overrides;
    return scene;
}

Scene read_scene(const fs::path& path, const std::optional<std::string>& variant,
                 const std::vector<std::string>& overrides) {
    const std::string text = with_sample_files(with_outlines(scene_text(path), path), path);
    Scene scene = parse_scene(text, path.string(), variant, overrides);
    scene.path = fs::absolute(path).lexically_normal().string();  // a report may be made from anywhere
    scene.analysis.folder = fs::path(scene.path).parent_path();
    return scene;
}

}  // namespace wetdeck
