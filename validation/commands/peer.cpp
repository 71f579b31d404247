// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck peer`: a scene on three meshes of another code, beside runs of this one.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/metrics/convergence.hpp"
#include "validation/peer/foam_peer.hpp"
#include "validation/run/exit_code.hpp"

namespace wetdeck {
namespace {

struct PeerOptions {
    std::string format, scene, out, run;
    RunChoice choice;
    std::vector<double> cells{0.5, 0.7071067811865476, 1};
    std::vector<std::string> overrides;
    double limit = 3600;
};

std::string value_text(std::optional<double> value) {
    return value ? fmt::format("{:.5g}", *value) : "-";
}

void print_values(const PeerResult& result) {
    fmt::print("{}, scene {}, variant {}\n{:<26} {:>6} {:>44} {:>11} {:>10}  {}\n", result.code, result.scene,
               result.variant, "quantity", "unit", "values, coarse to fine", "limit", "GCI", "convergence");
    for (const PeerQuantity& quantity : result.quantities) {
        std::string values;
        for (const double value : quantity.values.value) values += fmt::format(" {:>10.5g}", value);
        fmt::print("{:<26} {:>6} {:>44} {:>11} {:>10}  {}\n", quantity.values.qoi, quantity.unit, values,
                   value_text(quantity.values.extrapolated), value_text(quantity.values.gci_fine),
                   quantity.values.verdict);
    }
}

void print_agreement(const PeerResult& result, const std::string& run) {
    const Summary summary = analyse_directory(run);
    const std::vector<ValidationRow> rows = peer_agreement({result}, summary.runs);
    if (rows.empty())
        throw InputError(fmt::format("--run {}: holds no run of scene {}, variant {}, with these quantities",
                                     run, result.scene, result.variant));
    fmt::print("\n{:<26} {:>6} {:>11} {:>10} {:>11} {:>10} {:>11}  {}\n", "quantity", "unit", "ours", "+-",
               "theirs", "+-", "difference", "verdict");
    for (const ValidationRow& row : rows)
        fmt::print("{:<26} {:>6} {:>11.5g} {:>10} {:>11.5g} {:>10} {:>11.4g}  {}\n", row.quantity, row.unit,
                   row.simulated, value_text(row.u_num), row.reference, value_text(row.u_data), row.error,
                   row.verdict);
}

int peer(PeerOptions options) {
    const Scene scene = read_scene(find_scene(options.scene), options.choice.variant, options.overrides);
    const double spacing = options.choice.particle_spacing.value_or(finest_quick_spacing(scene));
    std::sort(options.cells.begin(), options.cells.end());
    FoamPeerOptions wanted{{}, options.choice.until, options.limit};
    for (const double cells : options.cells) {
        if (!(cells > 0)) throw InputError(fmt::format("--cells: {} is not positive", cells));
        if (!wanted.cells.empty() && spacing / cells >= wanted.cells.back())
            throw InputError("--cells: expected different numbers");
        wanted.cells.push_back(spacing / cells);
    }
    const PeerResult result = run_foam_peer(scene, options.out, wanted);
    print_values(result);
    if (!options.run.empty()) print_agreement(result, options.run);
    fmt::print("{}/peer.json; a report of a directory that holds it shows both codes\n", options.out);
    return exit_done;
}

}  // namespace

void add_peer(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<PeerOptions>();
    CLI::App& command = *app.add_subcommand(
        "peer",
        "run a scene with OpenFOAM on three meshes and compare (needs OpenFOAM, for sections also gmsh)");
    command.add_option("format", options->format, "which code")
        ->required()
        ->type_name("")
        ->check(CLI::IsMember({"openfoam"}));
    add_scene(command, options->scene);
    add_run_choice(command, options->choice, "the finest of the quick tier");
    command
        .add_option("--cells", options->cells,
                    "cells per particle spacing of each mesh, between commas (default: 0.5,0.7071,1)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NUMBERS");
    add_overrides(command, options->overrides);
    command.add_option("--limit", options->limit, "wall time of all runs in seconds")
        ->type_name("S")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command
        .add_option("--run", options->run, "a run of this scene, or a directory of results, to compare with")
        ->type_name("DIR");
    command.add_option("--out", options->out, "folder of the cases, the curves and peer.json")
        ->required()
        ->type_name("DIR");
    command.footer(
        "Finished meshes are kept: the same command again runs only what is missing. Sections that are "
        "neither "
        "plates nor upright wedges need gmsh, too, and a build of OpenFOAM without the fault of Debian "
        "12's.");
    command.callback([options, &exit_code] { exit_code = peer(*options); });
}

}  // namespace wetdeck
