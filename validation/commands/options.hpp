// SPDX-License-Identifier: BSD-3-Clause
// Options that several commands share, and the functions that add them to a command. The name of an option's
// value (SCENE, VARIANT, TIER, ...) is also what completion knows it by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/run/run.hpp"

namespace CLI {
class App;
}

namespace wetdeck {

struct Scene;

/// Which run of a scene: its variant, spacing and end.
struct RunChoice {
    std::optional<std::string> variant;      ///< the scene's default if absent
    std::optional<double> particle_spacing;  ///< [m]
    std::optional<double> until;             ///< stop time [s], the scene's if absent
};
/// @param default_spacing  in words
void add_run_choice(CLI::App& command, RunChoice& choice, const char* default_spacing);

/// The spacing that is taken without --dx [m]. Throws InputError where the scene names none for its variant.
double finest_quick_spacing(const Scene& scene);

/// --variant
void add_variant(CLI::App& command, std::optional<std::string>& variant);
/// --set, as often as needed
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);
/// --tier
void add_tier(CLI::App& command, std::string& tier);

/// --until alone.
void add_until(CLI::App& command, std::optional<double>& until);

/// Threads and checkpoints of a run.
struct Resources {
    int threads = 0;                                                ///< 0: all processors
    double checkpoint_interval = RunOptions{}.checkpoint_interval;  ///< wall seconds
};
void add_resources(CLI::App& command, Resources& resources);

/// What a command prints.
struct Verbosity {
    bool json = false, quiet = false, verbose = false;
};
void add_verbosity(CLI::App& command, Verbosity& verbosity);

/// The scene, as first argument.
void add_scene(CLI::App& command, std::string& scene);
/// A directory with results, as argument.
void add_directory(CLI::App& command, std::string& directory, const char* description);
/// @param preset  in words
void add_out(CLI::App& command, std::string& directory, const char* preset);
/// A list of names.
/// @param kind  "scenes", "problems", "cases"
/// @param type  of the value: "SCENE", "PROBLEM", "CASE"
void add_only(CLI::App& command, std::vector<std::string>& names, const std::string& kind,
              const std::string& type);
void add_jobs(CLI::App& command, int& jobs);
void add_threads(CLI::App& command, int& threads, const char* description);
void add_checkpoint_interval(CLI::App& command, double& interval);
/// Which field files a run writes; @param otherwise  what is done without the option, in words
void add_fields(CLI::App& command, std::optional<Fields>& fields, const char* otherwise);
void add_fresh(CLI::App& command, bool& fresh);
void add_json(CLI::App& command, bool& json, const char* description = "print JSON, for scripts");
void add_quiet(CLI::App& command, bool& quiet);

}  // namespace wetdeck
