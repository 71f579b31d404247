// SPDX-License-Identifier: BSD-3-Clause
#include "validation/program/describe.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "validation/execute/progress.hpp"
#include "validation/scene/scene.hpp"
#include "validation/stress/cases.hpp"
#include "validation/verification/problems.hpp"

namespace wetdeck {

void print_list(bool as_json) {
    nlohmann::json scenes = nlohmann::json::array();
    for (const std::string& name : scene_names()) {
        const Scene scene = read_scene(find_scene(name));
        nlohmann::json variants = nlohmann::json::array();
        for (const VariantInfo& v : scene.variants)
            variants.push_back({{"name", v.name}, {"description", v.description}});
        scenes.push_back({{"name", name},
                          {"title", scene.analysis.title},
                          {"default_variant", scene.variant},
                          {"variants", variants}});
    }
    nlohmann::json problems = nlohmann::json::array();
    for (const verification::Problem& problem : verification::all_problems())
        problems.push_back({{"name", problem.name}, {"title", problem.title}, {"quick", problem.quick}});
    nlohmann::json hard = nlohmann::json::array();
    for (const stress::Case& member : stress::all_cases()) {
        nlohmann::json settings = nlohmann::json::array();
        for (const stress::Setting& setting : member.settings) settings.push_back(setting.name);
        hard.push_back({{"name", member.name}, {"title", member.title}, {"settings", settings}});
    }
    if (as_json) {
        const nlohmann::json all = {{"scenes", scenes}, {"problems", problems}, {"stress", hard}};
        fmt::print("{}\n", all.dump(1));
        return;
    }
    fmt::print("Scenes\n");
    for (const auto& scene : scenes) {
        fmt::print("  {}  {}\n", scene["name"].get<std::string>(), scene["title"].get<std::string>());
        for (const auto& v : scene["variants"]) {
            fmt::print("      {:14} {}\n", v["name"].get<std::string>(), v["description"].get<std::string>());
        }
    }
    fmt::print("Problems with exact solutions (wetdeck verify)\n");
    for (const auto& problem : problems)
        fmt::print("  {:20} {}\n", problem["name"].get<std::string>(), problem["title"].get<std::string>());
    fmt::print("Hard cases (wetdeck stress)\n");
    for (const auto& member : hard)
        fmt::print("  {:20} {}\n", member["name"].get<std::string>(), member["title"].get<std::string>());
}

void print_description(const std::string& name) {
    const std::filesystem::path path = find_scene(name);
    const Scene scene = read_scene(path);
    const Vec2 size = scene.tank.high - scene.tank.low;
    fmt::print("{} ({})\n{}\nsource: {}\nfile: {}\n\n", scene.analysis.title, scene.name(),
               scene.analysis.purpose, scene.analysis.source, path.string());
    fmt::print("Set-up\n  tank {:.4g} x {:.4g} m, g = ({:.4g}, {:.4g}) m/s2, end at {:.4g} s\n", size.x(),
               size.y(), scene.model.gravity.x(), scene.model.gravity.y(), scene.end_time);
    fmt::print("  water {:.4g} kg/m3, sound speed {:.4g} m/s; background pressure {:.4g} Pa\n",
               scene.model.water.eos.reference_density, scene.model.water.eos.sound_speed,
               scene.model.water.eos.background_pressure);
    if (scene.air) {
        fmt::print("  air {:.4g} kg/m3, sound speed {:.4g} m/s\n", scene.model.air.eos.reference_density,
                   scene.model.air.eos.sound_speed);
    }
    fmt::print("\nProbes\n");
    for (const ProbeSpec& probe : scene.probes) fmt::print("  {:16} {}\n", probe.name, probe.note);
    fmt::print("\nReferences\n");
    std::set<std::string> shown;
    for (const ComparisonSpec& c : scene.analysis.comparisons) {
        const std::filesystem::path file = reference_directory() / scene.name() / (c.reference + ".csv");
        if (!shown.insert(c.reference + c.quantity).second) continue;
        fmt::print(
            "  {:16} against {}{}\n", c.quantity, c.reference,
            std::filesystem::exists(file) ? "" : "  (curve not available: put it at " + file.string() + ")");
    }
    fmt::print("\nDeviations from the source\n");
    for (const Deviation& d : scene.analysis.deviations)
        fmt::print("  {}: {} -> {} ({})\n", d.item, d.source, d.used, d.reason);
    fmt::print("\nCost, estimated for one core with AVX-512\n  {:10} {:14} {:>8} {:>12} {:>10} {:>16}\n",
               "tier", "variant", "dx [m]", "particles", "steps", "time");
    for (const auto& [tier, variants] : scene.tiers) {
        for (const auto& [variant, spacings] : variants) {
            const Scene varied = read_scene(path, variant);
            for (const double dx : spacings) {
                const CostEstimate cost = estimate_cost(varied, dx);
                fmt::print("  {:10} {:14} {:>8} {:>12.0f} {:>10.0f} {:>16}\n", tier, variant, dx,
                           cost.fluid_particles, cost.steps, duration_text(cost.core_seconds));
            }
        }
    }
}

}  // namespace wetdeck
