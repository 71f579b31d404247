// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck list`: scenes, problems with exact solutions and hard cases.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/scene/scene.hpp"
#include "validation/stress/cases.hpp"
#include "validation/verification/problems.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

json scenes_json() {
    json scenes = json::array();
    for (const std::string& name : scene_names()) {
        const Scene scene = read_scene(find_scene(name));
        json variants = json::array();
        for (const VariantInfo& v : scene.variants)
            variants.push_back({{"name", v.name}, {"description", v.description}});
        scenes.push_back({{"name", name},
                          {"title", scene.analysis.title},
                          {"default_variant", scene.variant},
                          {"variants", variants}});
    }
    return scenes;
}

json problems_json() {
    json problems = json::array();
    for (const verification::Problem& problem : verification::all_problems())
        problems.push_back({{"name", problem.name}, {"title", problem.title}, {"quick", problem.quick}});
    return problems;
}

json cases_json() {
    json cases = json::array();
    for (const stress::Case& one : stress::all_cases()) {
        json settings = json::array();
        for (const stress::Setting& setting : one.settings) settings.push_back(setting.name);
        cases.push_back({{"name", one.name}, {"title", one.title}, {"settings", settings}});
    }
    return cases;
}

void print_titles(const char* heading, const json& entries) {
    fmt::print("{}\n", heading);
    for (const json& entry : entries)
        fmt::print("  {:20} {}\n", entry["name"].get<std::string>(), entry["title"].get<std::string>());
}

int list(bool as_json) {
    const json scenes = scenes_json(), problems = problems_json(), cases = cases_json();
    if (as_json) {
        const json all = {{"scenes", scenes}, {"problems", problems}, {"stress", cases}};
        fmt::print("{}\n", all.dump(1));
        return exit_done;
    }
    fmt::print("Scenes\n");
    for (const json& scene : scenes) {
        fmt::print("  {}  {}\n", scene["name"].get<std::string>(), scene["title"].get<std::string>());
        for (const json& v : scene["variants"])
            fmt::print("      {:20} {}\n", v["name"].get<std::string>(), v["description"].get<std::string>());
    }
    print_titles("Problems with exact solutions (wetdeck verify)", problems);
    print_titles("Hard cases (wetdeck stress)", cases);
    return exit_done;
}

}  // namespace

void add_list(CLI::App& app, int& exit_code) {
    const auto as_json = std::make_shared<bool>(false);
    CLI::App& command =
        *app.add_subcommand("list", "scenes with their variants, problems with exact solutions, hard cases");
    add_json(command, *as_json);
    command.callback([as_json, &exit_code] { exit_code = list(*as_json); });
}

}  // namespace wetdeck
