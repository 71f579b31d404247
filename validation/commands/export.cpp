// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck export`: a scene as a case of another code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/openfoam/case_folder.hpp"
#include "validation/openfoam/scene_case.hpp"
#include "validation/run/exit_code.hpp"

namespace wetdeck {
namespace {

struct ExportOptions {
    std::string format, scene, out;
    RunChoice choice;
    double cells = 1;
    std::vector<std::string> overrides;
    bool replace = false;
};

int export_case(const ExportOptions& options) {
    const Scene scene = read_scene(find_scene(options.scene), options.choice.variant, options.overrides);
    if (!(options.cells > 0))
        throw InputError(fmt::format("--cells is {}, expected a positive number", options.cells));
    const double spacing = options.choice.particle_spacing.value_or(finest_quick_spacing(scene));
    const SceneCase written = scene_case(scene, spacing / options.cells, options.choice.until);
    write_case(options.out, scene, written, options.replace);
    fmt::print("{}: {} with {} cells of {:.4g} m, until {:.4g} s; run it with {}/run.sh\n", options.out,
               written.foam.solver(), written.foam.mesh.cells.size(), written.cell, written.foam.end_time,
               options.out);
    fmt::print("What differs from the scene: {}/DIFFERENCES.md\n", options.out);
    return exit_done;
}

}  // namespace

void add_export(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App& command =
        *app.add_subcommand("export", "write a scene as a case of OpenFOAM (sections need gmsh)");
    command.add_option("format", options->format, "of which code")
        ->required()
        ->type_name("")
        ->check(CLI::IsMember({"openfoam"}));
    add_scene(command, options->scene);
    add_run_choice(command, options->choice, "the finest of the quick tier");
    command.add_option("--cells", options->cells, "cells per particle spacing")
        ->type_name("NUMBER")
        ->capture_default_str();
    add_overrides(command, options->overrides);
    command.add_option("--out", options->out, "folder of the case")->required()->type_name("DIR");
    command.add_flag("--replace", options->replace, "write into the folder though it holds files");
    command.footer(
        fmt::format("Supported are {}. Sections need gmsh (apt install gmsh), nothing needs OpenFOAM. "
                    "DIFFERENCES.md in the "
                    "folder names all that differs from the scene.",
                    foam_supported));
    command.callback([options, &exit_code] { exit_code = export_case(*options); });
}

}  // namespace wetdeck
