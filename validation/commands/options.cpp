// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

void add_count(CLI::App& command, const char* name, int& value, const char* description) {
    command.add_option(name, value, description)->check(CLI::Range(1, 4096))->type_name("N");
}

/// What the value of an option is: its name in the help, and in words with its unit.
struct Quantity {
    const char *type, *words;
};

/// An option whose value must be positive and finite.
void add_positive(CLI::App& command, const std::string& name, std::optional<double>& value,
                  const Quantity& quantity, const std::string& description) {
    const auto store = [name, quantity, &value](const double& given) {
        if (!(given > 0) || !std::isfinite(given))
            throw InputError(fmt::format("{} is {}, expected a positive {}", name, given, quantity.words));
        value = given;
    };
    command.add_option_function<double>(name, store, description)->type_name(quantity.type);
}

}  // namespace

void add_until(CLI::App& command, std::optional<double>& until) {
    add_positive(command, "--until", until, {"S", "time [s]"}, "stop time [s] (default: that of the scene)");
}

double finest_quick_spacing(const Scene& scene) {
    if (scene.resolution && scene.resolution->finest) return *scene.resolution->finest;
    const auto tier = scene.tiers.find("quick");
    if (tier == scene.tiers.end() || tier->second.count(scene.variant) == 0)
        throw InputError("--dx is missing: the scene names no quick spacing for this variant");
    return tier->second.at(scene.variant).back();
}

void add_variant(CLI::App& command, std::optional<std::string>& variant) {
    command.add_option("--variant", variant, "variant of the scene (default: that of the scene)")
        ->type_name("VARIANT");
}

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
    command.add_option("--set", overrides, "override a key of the scene file; may be given several times")
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE");
}

void add_tier(CLI::App& command, std::string& tier) {
    command.add_option("--tier", tier, "quick, standard or paper")->type_name("TIER")->capture_default_str();
}

void add_run_choice(CLI::App& command, RunChoice& choice, const char* default_spacing) {
    add_variant(command, choice.variant);
    add_positive(command, "--dx", choice.particle_spacing, {"M", "spacing [m]"},
                 fmt::format("particle spacing [m] (default: {})", default_spacing));
    add_until(command, choice.until);
}

void add_resources(CLI::App& command, Resources& resources) {
    add_threads(command, resources.threads, "number of threads (default: all processors)");
    add_checkpoint_interval(command, resources.checkpoint_interval);
}

void add_verbosity(CLI::App& command, Verbosity& verbosity) {
    add_json(command, verbosity.json);
    add_quiet(command, verbosity.quiet);
    command.add_flag("-v,--verbose", verbosity.verbose,
                     "also print the time of each stage and what limited the time step");
}

void add_scene(CLI::App& command, std::string& scene) {
    command.add_option("scene", scene, "a name from `wetdeck list`, or the path of your own scene file")
        ->required()
        ->type_name("");
}

void add_directory(CLI::App& command, std::string& directory, const char* description) {
    command.add_option("directory", directory, description)->required()->type_name("");
}

void add_out(CLI::App& command, std::string& directory, const char* preset) {
    command.add_option("--out", directory, fmt::format("directory of the results (default: {})", preset))
        ->type_name("DIR");
}

void add_only(CLI::App& command, std::vector<std::string>& names, const std::string& kind,
              const std::string& type) {
    command.add_option("--only", names, fmt::format("{} to run, separated by commas (default: all)", kind))
        ->delimiter(',')
        ->type_name(type + ",...");
}

void add_jobs(CLI::App& command, int& jobs) {
    add_count(command, "--jobs", jobs, "number of runs at a time (default: one per core)");
}

void add_threads(CLI::App& command, int& threads, const char* description) {
    add_count(command, "--threads", threads, description);
}

void add_checkpoint_interval(CLI::App& command, double& interval) {
    command
        .add_option("--checkpoint-interval", interval,
                    "wall seconds between checkpoints; longer where checkpoints would take more than 1 % "
                    "of the time; 0: a checkpoint at every opportunity")
        ->check(CLI::Range(0.0, 1e9))
        ->type_name("SECONDS")
        ->capture_default_str();
}

void add_fields(CLI::App& command, std::optional<Fields>& fields, const char* otherwise) {
    const auto take = [&fields](const std::string& name) {
        const auto found = std::find(fields_names.begin(), fields_names.end(), name);
        fields = static_cast<Fields>(found - fields_names.begin());
    };
    command
        .add_option_function<std::string>(
            "--fields", take,
            fmt::format("field files: none, key (those that the report shows) or all (default: {})",
                        otherwise))
        ->check(CLI::IsMember(std::vector<std::string>(fields_names.begin(), fields_names.end())))
        ->type_name("WHICH");
}

void add_fresh(CLI::App& command, bool& fresh) {
    command.add_flag("--fresh", fresh, "repeat finished runs");
}

void add_json(CLI::App& command, bool& json, const char* description) {
    command.add_flag("--json", json, description);
}

void add_quiet(CLI::App& command, bool& quiet) {
    command.add_flag("-q,--quiet", quiet, "print results and errors only, no progress");
}

}  // namespace wetdeck
