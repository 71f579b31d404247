// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck describe`: the set-up, references and cost of one scene, or the keys of a scene file.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "solver/time/time_step.hpp"
#include "validation/analytic/curves.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/run/progress.hpp"
#include "validation/scene/body_figures.hpp"
#include "validation/scene/identity.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/scene_keys.hpp"
#include "validation/scene/scheme_differences.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

json material_json(const Material& material) {
    return {{"density", material.eos.reference_density}, {"sound_speed", material.eos.sound_speed}};
}

json references_of(const Scene& scene) {
    json all = json::array();
    std::set<std::string> shown;
    for (const ComparisonSpec& c : scene.analysis.comparisons) {
        if (!shown.insert(c.reference + c.quantity).second) continue;
        const bool computed = is_analytic(c.reference);
        const std::filesystem::path file =
            reference_file(c.reference, scene.analysis.folder, reference_directory() / scene.name());
        all.push_back({{"series", c.quantity},
                       {"reference", c.reference},
                       {"available", computed || std::filesystem::exists(file)},
                       {"file", computed ? "" : file.string()}});
    }
    return all;
}

/// What every run of the scene records beside its probes.
json series_of(const Scene& scene) {
    json all = json::array();
    const auto add = [&all](const auto& table) {
        for (const auto& row : table)
            all.push_back(
                {{"name", row.info.name}, {"unit", row.info.unit}, {"description", row.info.description}});
    };
    add(every_run_series());
    add(analysed_series());
    add(field_series(scene));
    if (!scene.bodies.empty()) {
        add(recorded_body_series());
        add(derived_body_series());
    }
    return all;
}

json costs_of(const Scene& scene, const std::filesystem::path& path) {
    json all = json::array();
    for (const auto& [tier, variants] : scene.tiers) {
        for (const auto& [variant, spacings] : variants) {
            const Scene varied = read_scene(path, variant);
            for (const double dx : spacings) {
                const CostEstimate cost = estimate_cost(varied, dx);
                all.push_back({{"tier", tier},
                               {"variant", variant},
                               {"dx", dx},
                               {"particles", cost.fluid_particles},
                               {"steps", cost.steps},
                               {"core_s", cost.core_seconds}});
            }
        }
    }
    return all;
}

json body_json(const Scene& scene, const BodySpec& body) {
    const BodyFigures figures = body_figures(scene, body);
    json all = {{"name", body.name},
                {"mass", body.body.mass},
                {"inertia", body.body.inertia},
                {"corners", body.outline.size()},
                {"area", figures.area},
                {"beam", figures.beam}};
    const auto add = [&all](const char* key, const std::optional<double>& value) {
        all[key] = value ? json(*value) : json(nullptr);
    };
    add("draught_at_rest", figures.draught);
    add("heave_period", figures.heave_period);
    add("speed", figures.speed);
    add("froude", figures.froude);
    add("reynolds", figures.reynolds);
    add("mach", figures.mach);
    add("first_contact", figures.first_contact);
    return all;
}

json description(const std::string& name, const std::optional<std::string>& variant) {
    const std::filesystem::path path = find_scene(name);
    const Scene scene = read_scene(path, variant);
    const Vec2 size = scene.tank.high - scene.tank.low;
    json all = {{"name", scene.name()},
                {"title", scene.analysis.title},
                {"purpose", scene.analysis.purpose},
                {"variant", scene.variant},
                {"source", scene.analysis.source},
                {"file", path.string()},
                {"tank", {size.x(), size.y()}},
                {"gravity", {scene.model.gravity.x(), scene.model.gravity.y()}},
                {"end_time", scene.end_time},
                {"water", material_json(scene.model.water)},
                {"background_pressure", scene.model.water.eos.background_pressure},
                {"parameters", parameters_json(scene)},
                {"bodies", json::array()},
                {"probes", json::array()},
                {"deviations", json::array()},
                {"scheme_differences", json::array()},
                {"series", series_of(scene)},
                {"references", references_of(scene)},
                {"unused_references", json::array()},
                {"cost", costs_of(scene, path)}};
    if (scene.air) {
        all["air"] = material_json(scene.model.air);
        all["air"]["substeps"] = air_substeps(scene.model);
    }
    for (const BodySpec& body : scene.bodies) all["bodies"].push_back(body_json(scene, body));
    for (const Probe& probe : scene.probes)
        all["probes"].push_back({{"name", probe.series.name}, {"note", probe.note}});
    for (const UnusedReference& unused : scene.analysis.unused_references)
        all["unused_references"].push_back({{"reference", unused.file}, {"reason", unused.reason}});
    for (const Deviation& d : scene.analysis.deviations)
        all["deviations"].push_back(
            {{"item", d.item}, {"source", d.source}, {"used", d.used}, {"reason", d.reason}});
    for (const SchemeDifference& d : scheme_differences(scene))
        all["scheme_differences"].push_back({{"key", d.key},
                                             {"meaning", d.meaning},
                                             {"equation", d.equation},
                                             {"source", d.source},
                                             {"used", d.used}});
    return all;
}

std::string text(const json& value) {
    return value.get<std::string>();
}

double number(const json& value) {
    return value.get<double>();
}

void print_body(const json& body) {
    fmt::print("  {} of {} corners, {:.4g} kg/m, {:.4g} kg m about its mass centre\n", text(body["name"]),
               body["corners"].get<int>(), number(body["mass"]), number(body["inertia"]));
    std::string line =
        fmt::format("    area {:.4g} m2, beam {:.4g} m", number(body["area"]), number(body["beam"]));
    const auto add = [&](const char* key, const char* words, const char* unit) {
        if (!body[key].is_null()) line += fmt::format(", {} {:.4g}{}", words, number(body[key]), unit);
    };
    add("draught_at_rest", "draught at rest", " m");
    add("heave_period", "natural period of heave about", " s");
    add("speed", "speed", " m/s");
    add("first_contact", "first contact at", " s");
    add("froude", "Froude number", "");
    add("reynolds", "Reynolds number", "");
    add("mach", "Mach number", "");
    fmt::print("{}\n", line);
}

void print_set_up(const json& all) {
    fmt::print("Set-up\n  tank {:.4g} x {:.4g} m, g = ({:.4g}, {:.4g}) m/s2, end at {:.4g} s\n",
               number(all["tank"][0]), number(all["tank"][1]), number(all["gravity"][0]),
               number(all["gravity"][1]), number(all["end_time"]));
    fmt::print("  water {:.4g} kg/m3, sound speed {:.4g} m/s; background pressure {:.4g} Pa\n",
               number(all["water"]["density"]), number(all["water"]["sound_speed"]),
               number(all["background_pressure"]));
    fmt::print("  viscosity of the water {:.4g} Pa s, viscous force {}\n",
               number(all["parameters"]["water.viscosity"]), text(all["parameters"]["model.viscosity"]));
    if (all.contains("air")) {
        fmt::print("  air {:.4g} kg/m3, sound speed {:.4g} m/s; steps of the air per step of the water: {}\n",
                   number(all["air"]["density"]), number(all["air"]["sound_speed"]),
                   all["air"]["substeps"].get<int>());
    }
    for (const json& body : all["bodies"]) print_body(body);
}

/// The model's choices, defaults included.
void print_model(const json& all) {
    fmt::print("\nModel (`wetdeck describe --keys` explains the keys)\n");
    for (const auto& [key, value] : all["parameters"].items())
        if (key.starts_with("model.") || key.starts_with("contact."))
            fmt::print("  {:30} {}\n", key, value.is_string() ? text(value) : value.dump());
}

void print_series(const json& all) {
    fmt::print("\nProbes\n");
    for (const json& probe : all["probes"])
        fmt::print("  {:16} {}\n", text(probe["name"]), text(probe["note"]));
    fmt::print("\nRecorded in every run (series of a second body end in _2)\n");
    for (const json& s : all["series"])
        fmt::print("  {:34} {:7} {}\n", text(s["name"]), text(s["unit"]), text(s["description"]));
}

void print_references(const json& all) {
    fmt::print("\nReferences\n");
    for (const json& c : all["references"]) {
        fmt::print("  {:16} against {}{}\n", text(c["series"]), text(c["reference"]),
                   c["available"] ? ""
                                  : "  (curve not available: put it beside the scene file or at " +
                                        text(c["file"]) + ")");
    }
    if (!all["unused_references"].empty()) fmt::print("\nReference files that no comparison uses\n");
    for (const json& unused : all["unused_references"])
        fmt::print("  {:34} {}\n", text(unused["reference"]), text(unused["reason"]));
    if (!all["scheme_differences"].empty())
        fmt::print("\nScheme of this variant: differences from the source, key by key\n");
    for (const json& d : all["scheme_differences"])
        fmt::print("  {:30} {} -> {}  {}\n", text(d["key"]), text(d["source"]), text(d["used"]),
                   text(d["equation"]));
    fmt::print("\nDeviations of the scene from the source\n");
    for (const json& d : all["deviations"])
        fmt::print("  {}: {} -> {} ({})\n", text(d["item"]), text(d["source"]), text(d["used"]),
                   text(d["reason"]));
}

void print_costs(const json& all) {
    fmt::print("\nCost, estimated for one core with AVX-512\n  {:10} {:14} {:>8} {:>12} {:>10} {:>16}\n",
               "tier", "variant", "dx [m]", "particles", "steps", "time");
    for (const json& cost : all["cost"])
        fmt::print("  {:10} {:14} {:>8.4g} {:>12.0f} {:>10.0f} {:>16}\n", text(cost["tier"]),
                   text(cost["variant"]), number(cost["dx"]), number(cost["particles"]),
                   number(cost["steps"]), duration_text(number(cost["core_s"])));
}

json keys_json() {
    json all = json::array();
    for (const SceneKeySection& section : scene_keys())
        for (const SceneKey& key : section.keys)
            all.push_back({{"key", key.key},
                           {"section", section.title},
                           {"unit", key.unit},
                           {"default", key.fallback},
                           {"range", key.range},
                           {"meaning", key.meaning},
                           {"choice", key.choice},
                           {"equation", key.equation}});
    return all;
}

struct DescribeOptions {
    std::string scene;
    std::optional<std::string> variant;
    bool keys = false, json = false;
};

int describe(const DescribeOptions& options) {
    if (options.keys) {
        if (options.json)
            fmt::print("{}\n", keys_json().dump(1));
        else
            fmt::print("{}", scene_keys_markdown());
        return exit_done;
    }
    if (options.scene.empty()) throw InputError("describe: expected a scene, or --keys");
    const json all = description(options.scene, options.variant);
    if (options.json) {
        fmt::print("{}\n", all.dump(1));
        return exit_done;
    }
    fmt::print("{} ({})\n{}\nsource: {}\nfile: {}\n\n", text(all["title"]), text(all["name"]),
               text(all["purpose"]), text(all["source"]), text(all["file"]));
    print_set_up(all);
    print_model(all);
    print_series(all);
    print_references(all);
    print_costs(all);
    return exit_done;
}

}  // namespace

void add_describe(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<DescribeOptions>();
    CLI::App& command = *app.add_subcommand("describe", "set-up, references and estimated cost of one scene");
    command
        .add_option("scene", options->scene, "a name from `wetdeck list`, or the path of your own scene file")
        ->type_name("");
    command.add_option("--variant", options->variant, "variant of the scene (default: that of the scene)")
        ->type_name("VARIANT");
    command.add_flag(
        "--keys", options->keys,
        "instead: every key of a scene file with unit, default, range, meaning and how to choose it");
    add_json(command, options->json);
    command.callback([options, &exit_code] { exit_code = describe(*options); });
}

}  // namespace wetdeck
